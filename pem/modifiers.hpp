#pragma once
// What a diagnosis lets a case differ by from its parameters. No keys of a case; `simulate` does not know them.

#include <map>
#include <string>
#include <vector>

#include "lanes/factor_curve.hpp"
#include "pem/force_spectrum.hpp"
#include "spectra/log_spline.hpp"
#include "track/track_modifiers.hpp"
#include "vehicle/vehicle_modifiers.hpp"

namespace railpem::pem {

/// What each wheel meets by itself, incoherent from wheel to wheel, as a share of the power of the irregularity: what
/// seats that are not alike, a play of the fastenings or ground that changes along the line leave beside the mean of a
/// uniform track. Straight over the logarithm of frequency between nodes; no nodes: nothing.
struct WheelsOwn {
    std::vector<double> frequency_hz;  ///< > 0, increasing
    std::vector<double> share;         ///< one per node, ≥ 0

    bool empty() const { return frequency_hz.empty(); }
    double at(double frequency) const {
        double own = 0.0;
        for (std::size_t node = 0; node < frequency_hz.size(); ++node)
            own += ForceSpectrum::weight(frequency_hz, node, frequency) * share[node];
        return own;
    }
};

/// Free corrections: complex factors over frequency, 1 when empty, forces and irregularity of their own, none when
/// empty.
struct Modifiers {
    vehicle::VehicleModifiers vehicle;
    track::TrackModifiers track;
    lanes::FactorCurve contact;                         ///< on the linear contact stiffness
    std::map<std::string, lanes::FactorCurve> sensors;  ///< on the transfer of a channel, not on its noise
    ForceSpectrum primary_forces, secondary_forces;     ///< of every element of the stage, beside its law
    WheelsOwn wheels_own;
    /// the same by wavelength, as a logarithm of the share: where the contact line wanders and seats scatter, at every
    /// speed alike; no nodes: nothing
    spectra::LogSpline met_alone;

    /// Share of the irregularity's power at a frequency > 0 that each wheel meets by itself.
    double share_met_alone(double frequency_hz, double speed_m_per_s) const {
        return wheels_own.at(frequency_hz) + (met_alone.empty() ? 0.0 : met_alone.at(speed_m_per_s / frequency_hz));
    }
    bool has_met_alone() const { return !wheels_own.empty() || !met_alone.empty(); }
};

}  // namespace railpem::pem
