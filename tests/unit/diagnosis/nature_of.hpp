#pragma once
// What the field lists say that a number is, by its dotted key.

#include <string>

#include "parameters/field.hpp"
#include "pem/contact_parameters.hpp"
#include "track/track_parameters.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::diagnosis {

inline parameters::Nature nature_of(const std::string& key) {
    const std::string name = key.substr(key.rfind('.') + 1);
    parameters::Nature nature = parameters::Nature::other;
    const auto look = [&](const auto& fields) {
        for (const auto& field : fields)
            if (field.description.key == name) nature = field.description.nature;
    };
    look(vehicle::vehicle_fields());
    look(vehicle::suspension_fields());
    look(track::rail_fields());
    look(track::pad_fields());
    look(track::support_fields());
    look(pem::contact_fields());
    return nature;
}

}  // namespace railpem::diagnosis
