#include "app/schema/believed_case.hpp"

#include <cmath>

#include "app/schema/case_numbers.hpp"
#include "app/schema/effect_tables.hpp"
#include "pem/contact.hpp"

namespace railpem::app {

diagnosis::BelievedCase believed_case(const CaseFile& file) {
    diagnosis::BelievedCase believed{.numbers = file.without_effects, .effects = file.effects};
    pem::CaseParameters& numbers = believed.numbers;
    if (numbers.contact.constant_m_per_n23 == 0.0)
        numbers.contact.constant_m_per_n23 = pem::contact_constant(numbers.contact, numbers.vehicle.wheel_radius_m);
    if (numbers.sleeper_passing.amplitude_factor == 0.0) numbers.sleeper_passing.amplitude_factor = 1.0;
    believed.access = parameter_access(numbers);
    for (const CaseNumber& number : case_numbers(numbers)) {
        const double value = number.get(numbers);
        if (number.tolerance <= 0.0 || value == 0.0 || !std::isfinite(value)) continue;
        believed.uncertain.push_back({.key = number.key,
                                      .value = value,
                                      .tolerance = number.tolerance,
                                      .element = diagnosis::element_of_key(number.key),
                                      .range = number.description.range,
                                      .unit = number.description.unit,
                                      .nature = number.description.nature});
    }
    return believed;
}

}  // namespace railpem::app
