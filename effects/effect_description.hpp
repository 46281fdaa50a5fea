#pragma once
// What an effect is called, what it is, and which numbers it has: written once for everybody who names it. How it acts
// is the business of those who compute: simulate/effects in time, diagnosis/effects in the frequency domain.

#include <optional>
#include <string>
#include <vector>

#include "effects/effect_draw.hpp"
#include "effects/element.hpp"

namespace railpem::effects {

/// How believable values are spread over the range before any data are seen.
enum class Spread { uniform, logarithmic };

/// What `simulate` takes of a number where it is not what a diagnosis looks for. Unset: the same.
struct Simulated {
    std::optional<double> low = {};
    std::optional<double> high = {};
    std::optional<double> standard = {};  ///< taken where `--hide` does not state it, in place of the typical value
};

/// A continuous parameter of an effect.
struct EffectParameter {
    std::string name;  ///< with its unit
    std::string unit;
    double low = 0.0;  ///< of the physical range, ends included
    double high = 1.0;
    double typical = 0.5;  ///< a moderate strength, for figures and starting points
    Spread spread = Spread::uniform;
    bool strength = false;  ///< the effect vanishes as all parameters so marked go to `nothing`
    double nothing = 0.0;   ///< may be infinite, or lie outside of the range
    /// the effect is a source of its own whose power grows with (value − nothing)²: no derivative at nothing shows it
    bool amplitude = false;
    /// bends the law of an effect that is there: sought from its typical value alone, and the march has its own law
    bool law = false;
    /// a distance with lines at all multiples of v/distance: its divisors and multiples have many of them too
    bool comb = false;
    /// relative standard deviation by which fitted values miss those of marched records beyond what the data leave
    /// open: what the law itself gets wrong
    double inexact = 0.0;
    /// distance from `nothing` below which nobody would speak of the effect: models are off by as much
    double least = 0.0;
    Simulated simulated = {};
    std::string in_short = {};  ///< what it is, in the list of `simulate`; empty: as it says
    std::string says;
};

/// A discrete parameter: which wheel, order, channel, stage, key of the case. Written in files as text or whole number.
struct EffectChoice {
    std::string name;
    std::vector<std::string> options = {};  ///< empty: any number of the case by its dotted key
    bool whole_number = false;              ///< options are whole numbers, without gaps
    bool required = true;
    std::string replaces = {};  ///< parameter that means nothing, and must not be given, beside this choice
    bool is_element = false;    ///< options are names of elements: the effect sits in the one that is chosen
    Simulated simulated = {};   ///< of whole numbers; where they are not required the standard 0 is none of them
    std::string in_short = {};  ///< as of a parameter
    std::string says;
};

/// A band of frequencies in which an effect shows, Hz, for a car of some 10 t axle load at 80 km/h.
struct Band {
    double low_hz;
    double high_hz;
};

/// One effect, complete but for its physics.
struct EffectDescription {
    std::string id;             ///< the name of its file, with hyphens
    int row = 0;                ///< place in the catalogue: the lower is listed, applied and drawn first; none twice
    int list_row = 0;           ///< the same in the list of `simulate`, where it stands elsewhere there; 0: as `row`
    std::string says;           ///< what was left out, one sentence in plain words
    std::string in_short = {};  ///< the same in the list of `simulate`; empty: as it says
    std::string equation = {};
    std::string source = {};  ///< literature
    std::vector<EffectParameter> parameters;
    std::vector<EffectParameter> only_simulated_parameters = {};  ///< which no fit knows
    std::vector<EffectChoice> choices = {};
    std::vector<Element> elements;  ///< where it sits; several when a choice decides
    std::vector<Band> bands = {};
    std::string mimics = {};    ///< what looks like it, and what would tell them apart
    std::string not_told = {};  ///< what of its law no recording of the usual kind tells: said wherever it is named
    int most_instances = 1;     ///< of one variant in a set
    /// nothing is missing: a number of the case is wrong. It is put right before anything is added
    bool wrong_number = false;
    /// it exists in the march alone, so that a diagnosis meets what it does not know; without equation, bands and
    /// mimics
    bool only_simulated = false;
    std::vector<EffectDraw> draws;  ///< none: the proof never hides it
};

/// "pad", "primary or secondary"; of more than two "where it belongs", or `many`.
std::string place_text(const EffectDescription& effect, const std::string& many = "where it belongs");

/// It belongs to the recording and not to the train.
bool is_of_sensor(const EffectDescription& effect);

}  // namespace railpem::effects
