#pragma once
// What a parameter is: key, unit, range, default, tolerance, a sentence and where its number comes from.
// The parser, the validation, the reference page, `--set`, sweeps and the retuned fit all read this one description.

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace railpem::parameters {

enum class Kind { boolean, integer, number, choice, text, numbers };

/// A value as it stands in a file. `choice` and `text` are strings.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// The values a number may take. Open ends are excluded from the range.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;
    bool high_open = false;

    bool contains(double value) const;  ///< false for NaN
    std::string text() const;           ///< in words, for messages: "greater than 0", "between 0 and 1"
};

Range positive();                        ///< (0, ∞)
Range not_negative();                    ///< [0, ∞)
Range positive_or_infinite();            ///< (0, ∞]
Range between(double low, double high);  ///< [low, high]
Range any_number();                      ///< every finite number

/// What a number is: it decides how far one that is wrong may go, and how it goes with a common scale of all forces.
/// loss: shares of a stiffness or its energy (loss factors, damping ratios, what a failed fastener has left); section:
/// second moments of area; contact: the constant G of δ = G·P^{2/3}.
enum class Nature { other, mass, inertia, section, stiffness, damping, loss, contact };

/// Everything about a parameter but where it is stored.
struct Description {
    std::string key;   ///< as in the file, within its table
    std::string unit;  ///< SI, "1" when it has none, "" for what is not a number
    Kind kind = Kind::number;
    Range range;
    std::vector<std::string> choices;  ///< for Kind::choice
    bool required = false;
    Nature nature = Nature::other;
    double tolerance = 0.0;  ///< relative standard deviation of a believed value; 0: not retuned by default
    std::string says;        ///< one sentence
    std::string source;      ///< where default, range or law come from; may be empty
};

// NOLINTBEGIN(performance-unnecessary-value-param): clang-tidy 14 does not see std::move in a template
/// A parameter of an `Owner` struct. `set` expects a value of the described kind that lies in the range.
template <class Owner>
struct Field {
    Description description;
    std::function<Value(const Owner&)> get;
    std::function<void(Owner&, const Value&)> set;

    Field required() const {
        auto copy = *this;
        copy.description.required = true;
        return copy;
    }
    Field of(Nature nature) const {
        auto copy = *this;
        copy.description.nature = nature;
        return copy;
    }
    Field tolerance(double relative) const {
        auto copy = *this;
        copy.description.tolerance = relative;
        return copy;
    }
    Field source(std::string text) const {
        auto copy = *this;
        copy.description.source = std::move(text);
        return copy;
    }
};

template <class Owner>
using Fields = std::vector<Field<Owner>>;

template <class Owner, class Member>
Field<Owner> plain_field(Kind kind, Member Owner::*member, Description description) {
    description.kind = kind;
    return {std::move(description), [member](const Owner& owner) { return Value(owner.*member); },
            [member](Owner& owner, const Value& value) { owner.*member = std::get<Member>(value); }};
}

template <class Owner>
Field<Owner> number(double Owner::*member, std::string key, std::string unit, Range range, std::string says) {
    return plain_field(Kind::number, member,
                       {.key = std::move(key), .unit = std::move(unit), .range = range, .says = std::move(says)});
}

template <class Owner>
Field<Owner> numbers(std::vector<double> Owner::*member, std::string key, std::string unit, Range range,
                     std::string says) {
    return plain_field(Kind::numbers, member,
                       {.key = std::move(key), .unit = std::move(unit), .range = range, .says = std::move(says)});
}

template <class Owner>
Field<Owner> boolean(bool Owner::*member, std::string key, std::string says) {
    return plain_field(Kind::boolean, member, {.key = std::move(key), .says = std::move(says)});
}

template <class Owner>
Field<Owner> text(std::string Owner::*member, std::string key, std::string says) {
    return plain_field(Kind::text, member, {.key = std::move(key), .says = std::move(says)});
}

template <class Owner>
Field<Owner> integer(int Owner::*member, std::string key, Range range, std::string says) {
    Description description{
        .key = std::move(key), .unit = "1", .kind = Kind::integer, .range = range, .says = std::move(says)};
    return {std::move(description), [member](const Owner& owner) { return Value(std::int64_t{owner.*member}); },
            [member](Owner& owner, const Value& value) {
                owner.*member = static_cast<int>(std::get<std::int64_t>(value));
            }};
}

/// An enumeration whose values are 0, 1, 2, … in the order of `choices`.
template <class Owner, class Enumeration>
Field<Owner> choice(Enumeration Owner::*member, std::string key, std::vector<std::string> choices, std::string says) {
    Description description{.key = std::move(key), .kind = Kind::choice, .choices = choices, .says = std::move(says)};
    return {std::move(description),
            [member, choices](const Owner& owner) { return Value(choices[static_cast<std::size_t>(owner.*member)]); },
            [member, choices](Owner& owner, const Value& value) {
                for (std::size_t i = 0; i < choices.size(); ++i)
                    if (choices[i] == std::get<std::string>(value)) owner.*member = static_cast<Enumeration>(i);
            }};
}

// NOLINTEND(performance-unnecessary-value-param)

}  // namespace railpem::parameters
