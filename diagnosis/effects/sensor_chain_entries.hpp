#pragma once
// Where in the chains of a case a sensor effect goes. Every entry of a channel multiplies all that reaches it, noise of
// the entries before it included, and then adds its own noise. What multiplies therefore goes to the front and noise to
// the back: the result does not depend on the order of the effects.

#include <string>

#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

/// The first entry of the channel, made at the end of the list when there is none.
pem::SensorParameters& first_entry(pem::CaseParameters& parameters, const std::string& channel);

/// A new entry before the first one of the channel.
pem::SensorParameters& entry_before(pem::CaseParameters& parameters, const std::string& channel);

/// The last entry of the channel if it has no noise, else a new one behind it.
pem::SensorParameters& noise_entry(pem::CaseParameters& parameters, const std::string& channel);

}  // namespace railpem::diagnosis
