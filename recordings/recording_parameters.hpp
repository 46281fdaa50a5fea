#pragma once
// The keys of a recording's description and the rules between them.

#include "parameters/field.hpp"
#include "recordings/recording_description.hpp"

namespace railpem::recordings {

parameters::Fields<RecordingDescription> recording_fields();
parameters::Fields<ChannelDescription> channel_fields();

/// Rules between the keys. Throws parameters::ParameterError (keys as in the file, channels as "channel[3].index").
void check(const RecordingDescription& description);

}  // namespace railpem::recordings
