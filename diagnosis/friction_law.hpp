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

    /// A power below which a force is constant, and one above which it is another. Strong friction makes the velocity less Gaussian than its linearisation has it (more often near zero), and its forces
    /// stronger beside their damping; where it damps more than the stage's damper, a constant force looks like one that sticks.
    double constant_below() const;
    double another_above() const;
};

/// At the end of a fit whose caches are there (restore_caches()), to first order and with all its unknowns following, 1 believed within 1; none without friction or a time series of a vehicle. The fit has to have
/// seen the part of the recordings that `context` asks about: else its slope is none.
std::optional<FrictionLaw> friction_law(const Fit& fit, const LikelihoodContext& context);

/// It is not constant, by three deviations.
bool is_another(const FrictionLaw& law);

/// It may be constant and may not: nor is it constant by two.
bool is_open(const FrictionLaw& law);

/// By a normal law between the two.
double probability_of_another(const FrictionLaw& law);

/// The same in words.
std::string said_of(const FrictionLaw& law);

}  // namespace railpem::diagnosis
