#pragma once
// Whether friction is a constant force, or one that sticks harder than it slides.

#include <optional>
#include <string>

#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// What recordings say of the forces that friction has beside its equivalent damping (pem::friction_distortion): their
/// power in multiples of that of a constant force with the same damping where velocities are Gaussian, its standard
/// deviation, and what a constant force would seem to have (power_of_constant()). A force that jumps from one value to
/// another as the velocity changes its sign jumps by more than it slides with, where it sticks (Stribeck): damping and
/// jump are then no longer those of one force.
struct FrictionLaw {
    double power = 1.0;
    double deviation = 0.0;
    double expected = 1.0;
    bool at_one_speed = false;  ///< the recordings have no two speeds

    /// of the power over what is expected; a constant force whose sign does not jump but turns over some mm/s has less
    /// than 1
    double ratio() const;
    double uncertainty() const;  ///< of that, one deviation, with what realisations leave open
    /// the same for whoever calls it constant: a force so strong that it slides seldom, or one speed, tells little of
    /// what sticks harder
    double untold() const;
};

/// At the end of a fit whose caches are there (restore_caches()), to first order and with all its unknowns following, 1
/// believed within 1; none without friction or a time series of a vehicle. The fit has to have seen the part of the
/// recordings that `context` asks about: else its slope is none.
std::optional<FrictionLaw> friction_law(const Fit& fit, const LikelihoodContext& context);

/// The same without what is expected: 1.
std::optional<FrictionLaw> friction_power(const Fit& fit, const LikelihoodContext& context);

/// It is not constant, by three deviations.
bool is_another(const FrictionLaw& law);

/// It may be constant and may not: nor is it constant by two.
bool is_open(const FrictionLaw& law);

/// By a normal law between the two.
double probability_of_another(const FrictionLaw& law);

/// The same in words.
std::string said_of(const FrictionLaw& law);

}  // namespace railpem::diagnosis
