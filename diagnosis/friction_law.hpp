#pragma once
// Whether friction is a constant force, or one that sticks harder than it slides.

#include <optional>
#include <string>

#include "diagnosis/fit.hpp"

namespace railpem::diagnosis {

/// What recordings say of the forces that friction has beside its equivalent damping (pem::friction_distortion): their power in multiples of that of a constant force with the same damping, and its standard
/// deviation. A force that jumps from one value to another as the velocity changes its sign jumps by more than it slides with, where it sticks (Stribeck): damping and jump are then no longer those of one force.
struct FrictionLaw {
    double power = 1.0;
    double deviation = 0.0;
    double over_viscous = 0.0;  ///< FrictionLevel::over_viscous, of the stage where it is largest

    /// The most that a constant force shows. Strong friction makes the velocity less Gaussian than its linearisation has it (more often near zero), and its forces stronger beside their damping.
    double constant_at_most() const;
};

/// At the end of a fit whose caches are there (restore_caches()), to first order and with all its unknowns following, 1 believed within 1; none without friction or a time series of a vehicle. The fit has to have
/// seen the part of the recordings that `context` asks about: else its slope is none.
std::optional<FrictionLaw> friction_law(const Fit& fit, const LikelihoodContext& context);

/// It is not constant: the power is beyond the most of a constant force by more than three deviations and what that is uncertain by.
bool is_another(const FrictionLaw& law);

/// It may be constant and may not: the power may be beyond that most within two deviations, or friction is so strong that nobody knows what a constant force shows.
bool is_open(const FrictionLaw& law);

/// That the power is that much or more, by a normal law.
double probability_of_another(const FrictionLaw& law);

/// The same in words.
std::string said_of(const FrictionLaw& law);

}  // namespace railpem::diagnosis
