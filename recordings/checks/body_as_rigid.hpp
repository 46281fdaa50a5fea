#pragma once
// The middle of a rigid body moves with what stands on both sides of it.

#include <array>
#include <optional>

#include "recordings/estimates/cross_spectra.hpp"

namespace railpem::recordings::checks {

/// Three channels of acceleration on the body: before, at and behind its centre.
struct BodyChannels {
    std::array<std::size_t, 3> front_centre_rear{};
};

/// The outermost two and what lies between them, within 2 m of the centre; nothing where one is missing.
std::optional<BodyChannels> body_channels(const CrossSpectra& spectra);

/// middle = a·first + b·second below 5 Hz, where a body is rigid, by least squares over real parts of cross-spectra.
struct RigidFit {
    double a = 0.0, b = 0.0;
    double explained = 0.0;  ///< share of the middle's power
};
std::optional<RigidFit> rigid_fit(const CrossSpectra& spectra, std::size_t middle, std::size_t first,
                                  std::size_t second);

}  // namespace railpem::recordings::checks
