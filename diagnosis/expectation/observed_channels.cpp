#include "diagnosis/expectation/observed_channels.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "diagnosis/expectation/expectation_settings.hpp"
#include "pem/coupling/sensor_chain.hpp"
#include "pem/response_names.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;

std::string response_of(const recordings::ChannelDescription& channel, const pem::CaseParameters& parameters) {
    using recordings::Location;
    switch (channel.location) {
        case Location::wheel:
            return "wheel_" + std::to_string(channel.index);
        case Location::bogie:
            return "bogie_" + std::to_string(channel.index);
        case Location::rail:
            return "rail_" + std::to_string(channel.index);
        case Location::body: {
            const double within = kExpectationSettings.over_the_pivot_m;
            const double pivot = parameters.vehicle.bogie_distance_m / 2.0;
            if (std::abs(channel.position_m) < within) return "body";
            if (std::abs(channel.position_m - pivot) < within) return "body_front";
            if (std::abs(channel.position_m + pivot) < within) return "body_rear";
            return {};
        }
        case Location::none:
            return {};
    }
    return {};
}

}  // namespace

Complex channel_factor(const pem::CaseParameters& parameters, const ObservedChannel& channel, double frequency) {
    Complex factor = 1.0;
    for (int i = 0; i < channel.integrations; ++i) factor /= Complex(0.0, 2.0 * std::numbers::pi * frequency);
    if (parameters.sensors.empty() && parameters.modifiers.sensors.empty()) return factor;
    return factor * pem::channel_transfer(parameters, pem::response_names()[channel.response].where, frequency);
}

std::vector<ObservedChannel> observed_channels(const std::vector<recordings::ChannelDescription>& channels,
                                               const pem::CaseParameters& parameters) {
    std::vector<ObservedChannel> observed;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const std::string where = response_of(channels[c], parameters);
        if (where.empty() || channels[c].quantity > recordings::ChannelQuantity::displacement) continue;
        observed.push_back({c, pem::response_index(where), static_cast<int>(channels[c].quantity)});
    }
    return observed;
}

}  // namespace railpem::diagnosis
