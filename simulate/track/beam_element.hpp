#pragma once

#include <Eigen/Core>

#include "track/rail_parameters.hpp"

namespace railpem::simulate {

/// Section of the rail as the element needs it. Euler: shear_rigidity_n = ∞ is written as 0 flexibility.
struct Section {
    double bending_rigidity_n_m2;    ///< EI
    double shear_flexibility_per_n;  ///< 1/(κGA); 0 for the Euler beam
    double mass_kg_per_m;
    double rotary_inertia_kg_m;  ///< ρI; 0 for the Euler beam
};

Section section_of(const track::RailParameters& rail);

/// Two-node beam element with the degrees of freedom (w, θ) at either end, θ the rotation of the section. The shape
/// functions are the exact static ones between the nodes (cubic Hermite for Euler; interdependent interpolation for
/// Timoshenko, Friedman & Kosmatka 1993, Computers & Structures 47), so nodal displacements under static loads are
/// exact wherever the load stands.
Eigen::Matrix4d element_stiffness(const Section& section, double length_m);

/// Consistent mass with rotary inertia, integrated exactly by Gauss quadrature.
Eigen::Matrix4d element_mass(const Section& section, double length_m);

/// Displacement at distance `at_m` from the first node for unit nodal values; also the consistent load of a unit force
/// there.
Eigen::Vector4d displacement_shape(const Section& section, double length_m, double at_m);
Eigen::Vector4d rotation_shape(const Section& section, double length_m, double at_m);

/// Displacement at the loaded point itself for a unit force with both nodes held (w = θ = 0), m/N. This is what the
/// shape functions miss under the load; Euler: a³b³/(3·EI·l³). Added at the contact, the static deflection is exact
/// everywhere and no line at speed over element length appears.
double compliance_between_nodes(const Section& section, double length_m, double at_m);

}  // namespace railpem::simulate
