#include "app/schema/case_numbers.hpp"

#include <fmt/format.h>

#include "app/schema/case_schema.hpp"

namespace railpem::app {

using namespace parameters;

namespace {

/// Every number below a table, reached through `locate`: the table's struct within a case.
using Locate = std::function<void*(pem::CaseParameters&)>;

void collect_numbers(const TableSchema& schema, const std::string& prefix, const Locate& locate,
                     pem::CaseParameters& parameters, std::vector<CaseNumber>& numbers) {
    for (const FieldSchema& field : schema.fields) {
        if (field.description.kind != Kind::number) continue;
        CaseNumber number{.key = prefix + field.description.key,
                          .description = field.description,
                          .tolerance = field.description.tolerance};
        number.get = [get = field.get, locate](const pem::CaseParameters& owner) {
            return std::get<double>(get(locate(const_cast<pem::CaseParameters&>(owner))));
        };
        number.set = [set = field.set, locate](pem::CaseParameters& owner, double value) { set(locate(owner), value); };
        numbers.push_back(std::move(number));
    }
    for (const SubtableSchema& child : schema.tables) {
        const Locate within = [locate, member = child.member](pem::CaseParameters& owner) {
            return member(locate(owner));
        };
        collect_numbers(*child.table, prefix + child.name + ".", within, parameters, numbers);
    }
    for (const TableListSchema& list : schema.lists)
        for (std::size_t i = 0; i < list.size(locate(parameters)); ++i) {
            const Locate within = [locate, at = list.at, i](pem::CaseParameters& owner) {
                return at(locate(owner), i);
            };
            collect_numbers(*list.table, fmt::format("{}{}[{}].", prefix, list.name, i + 1), within, parameters,
                            numbers);
        }
}

}  // namespace

std::vector<CaseNumber> case_numbers(const pem::CaseParameters& parameters) {
    std::vector<CaseNumber> numbers;
    pem::CaseParameters shape = parameters;
    collect_numbers(
        case_schema(), "", [](pem::CaseParameters& owner) -> void* { return &owner; }, shape, numbers);
    for (CaseNumber& number : numbers) {
        std::vector<Step> steps = key_steps(number.key);
        for (const bool with_elements : {false, true}) {
            std::vector<Step> named = steps;
            if (!with_elements)
                for (Step& step : named) step.element = 0;
            const auto stated = parameters.tolerances.find(key_text(named));
            if (stated != parameters.tolerances.end()) number.tolerance = stated->second;
        }
    }
    return numbers;
}

}  // namespace railpem::app
