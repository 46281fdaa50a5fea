#include "diagnosis/likelihood/likelihood_context.hpp"

#include "diagnosis/likelihood/likelihood_settings.hpp"

namespace railpem::diagnosis {

LikelihoodContext blunted(const LikelihoodContext& context, double floor) {
    LikelihoodContext blunt = context;
    if (context.coarse) blunt.observations = context.coarse, blunt.every = kLikelihoodSettings.tempered_every;
    blunt.least_floor = floor;
    return blunt;
}

const MeasuredSpectra& measured(const Observation& observation, Part part) {
    return part == Part::fitted ? observation.fitted : part == Part::held_out ? observation.held_out : observation.all;
}

ExpectationOptions expectation_of(const Observation& observation, Part part) {
    ExpectationOptions options = observation.expectation;
    options.speeds = measured(observation, part).speeds;
    return options;
}

}  // namespace railpem::diagnosis
