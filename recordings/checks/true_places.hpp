#pragma once
// Where channels stand by what they meet, whatever their description says.

#include <optional>
#include <vector>

#include "recordings/checks/inspection_context.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/fault.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings::checks {

/// The places of all channels of a series after exchanged ones were put right. All other checks look at these, so that
/// an exchange is told once and not again as a skew, a sign or a speed.
struct TruePlaces {
    std::vector<ChannelDescription>
        channels;  ///< as described, but location, index, side and position of the exchanged
    std::vector<Fault> exchanges;
    std::optional<double> speed_m_per_s;  ///< median over the record at which axle boxes or bogies meet one track best
};

/// Axle boxes by trying all orders, bogies and ends of the body by whether the front one is first, centre and ends of
/// the body by which of them moves with the mean of the others. `detrended`: per channel, missing samples 0; `spectra`
/// may be null.
TruePlaces true_places(const TimeSeries& series, const InspectionContext& context,
                       const std::vector<std::vector<double>>& detrended, const CrossSpectra* spectra);

}  // namespace railpem::recordings::checks
