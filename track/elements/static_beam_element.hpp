#pragma once
// The two-node beam that is exact in statics.

#include <Eigen/Core>

namespace railpem::track {

/// Bending and shear of a beam element; shear_parameter φ = 12·EI/(κ·G·A·h²), 0 for the Euler beam.
struct StaticBeamElement {
    double length_m = 0.0;
    double bending_stiffness_n_m2 = 0.0;  ///< EI
    double shear_parameter = 0.0;         ///< φ
};

/// Stiffness for (deflection, rotation) of the near and the far node, in N/m, N and N·m (Przemieniecki 1968,
/// eq. 5.116).
Eigen::Matrix4d element_stiffness(const StaticBeamElement& element);

/// The shape functions at `share` ∈ [0, 1] of the length: deflection there for unit values at the nodes. They also turn
/// a point load into nodal loads; as they solve the unloaded beam, the nodal displacements stay exact (Reissner & Wan
/// 1976).
Eigen::Vector4d element_shape(const StaticBeamElement& element, double share);

/// Nodal loads of a uniform load of 1 N/m; shear does not change them.
Eigen::Vector4d element_uniform_load(const StaticBeamElement& element);

}  // namespace railpem::track
