#pragma once
// Which channels of a recording are responses of the model, and what lies between response and channel.

#include <complex>
#include <cstddef>
#include <vector>

#include "pem/case_parameters.hpp"
#include "recordings/recording.hpp"

namespace railpem::diagnosis {

/// Channels of a recording that the model knows: index of the channel and of the response.
struct ObservedChannel {
    std::size_t channel;
    std::size_t response;
    int integrations = 0;  ///< 0 acceleration, 1 velocity, 2 displacement
};

/// Pairs channels with responses by location and index (wheel n, bogie n, rail n; body by its position: centre or a
/// pivot within 0.25 m). Channels elsewhere are left out.
std::vector<ObservedChannel> observed_channels(const std::vector<recordings::ChannelDescription>& channels,
                                               const pem::CaseParameters& parameters);

/// From acceleration to the channel's quantity, and what its sensors do, at a frequency.
std::complex<double> channel_factor(const pem::CaseParameters& parameters, const ObservedChannel& channel,
                                    double frequency_hz);

}  // namespace railpem::diagnosis
