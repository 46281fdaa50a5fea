#include "diagnosis/observations/rail_sides.hpp"

#include <algorithm>

namespace railpem::diagnosis {

namespace {

using recordings::Side;

bool opposite(const recordings::ChannelDescription& a, const recordings::ChannelDescription& b) {
    return a.side == Side::left && b.side == Side::right && a.location == b.location && a.index == b.index &&
           a.position_m == b.position_m && a.quantity == b.quantity;
}

recordings::Recording without_side(recordings::Recording recording, Side side) {
    std::erase_if(recording.series.channels, [&](const recordings::Channel& channel) {
        return channel.description.side == side || (side == Side::left && channel.description.side == Side::unstated);
    });
    return recording;
}

}  // namespace

std::vector<SideRecording> one_rail_each(const recordings::Recording& recording) {
    const std::vector<recordings::Channel>& channels = recording.series.channels;
    const bool both = std::any_of(channels.begin(), channels.end(), [&](const recordings::Channel& a) {
        return std::any_of(channels.begin(), channels.end(),
                           [&](const recordings::Channel& b) { return opposite(a.description, b.description); });
    });
    if (!both) return {{"", recording}};
    return {{"_left", without_side(recording, Side::right)}, {"_right", without_side(recording, Side::left)}};
}

}  // namespace railpem::diagnosis
