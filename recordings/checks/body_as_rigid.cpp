#include "recordings/checks/body_as_rigid.hpp"

#include <algorithm>

namespace railpem::recordings::checks {

std::optional<BodyChannels> body_channels(const CrossSpectra& spectra) {
    constexpr double kFromCentre = 2.0;  // m
    std::optional<std::size_t> front, rear, centre;
    for (std::size_t i = 0; i < spectra.size(); ++i) {
        const ChannelDescription& c = spectra.channels[i];
        if (c.location != Location::body || c.quantity != ChannelQuantity::acceleration) continue;
        (c.position_m > kFromCentre ? front : c.position_m < -kFromCentre ? rear : centre) = i;
    }
    if (!front || !rear || !centre) return std::nullopt;
    return BodyChannels{{*front, *centre, *rear}};
}

std::optional<RigidFit> rigid_fit(const CrossSpectra& spectra, std::size_t middle, std::size_t first,
                                  std::size_t second) {
    double ff = 0.0, ss = 0.0, fs = 0.0, mf = 0.0, ms = 0.0, mm = 0.0;
    for (std::size_t k = 1; k < spectra.bins() && spectra.frequency_hz[k] <= 5.0; ++k) {
        if (spectra.frequency_hz[k] < 0.5) continue;
        ff += spectra.psd(k, first);
        ss += spectra.psd(k, second);
        mm += spectra.psd(k, middle);
        fs += spectra.at(k, first, second).real();
        mf += spectra.at(k, middle, first).real();
        ms += spectra.at(k, middle, second).real();
    }
    const double determinant = ff * ss - fs * fs;
    if (determinant < 1e-3 * ff * ss || mm <= 0.0) return std::nullopt;
    RigidFit fit{.a = (mf * ss - ms * fs) / determinant, .b = (ms * ff - mf * fs) / determinant};
    fit.explained = (fit.a * mf + fit.b * ms) / mm;
    return fit;
}

}  // namespace railpem::recordings::checks
