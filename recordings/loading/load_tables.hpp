#pragma once
// The kinds of recordings that are not time series. Each fills its member of the recording from recording.file, in SI
// units, and lists what it lacks. Throws ReadError or parameters::ParameterError.

#include "recordings/files/data_table.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// `frequency_hz`, one PSD column per channel in the channel's unit squared per Hz.
void load_psd(Recording& recording, const ReadLimits& limits);

/// `channel`, `frequency_hz`, `value`, optional `standard_error`: PSD values as a paper quotes them.
void load_points(Recording& recording, const ReadLimits& limits);

/// `frequency_hz` with `re_m_per_n` and `im_m_per_n`, or with `magnitude_m_per_n`; or a frequency response in a
/// universal file (displacement, velocity or acceleration over force), converted to receptance.
void load_receptance(Recording& recording, const ReadLimits& limits);

/// `centre_hz`, `decay_rate_db_per_m`, optional `standard_error_db_per_m`.
void load_decay_rate(Recording& recording, const ReadLimits& limits);

}  // namespace railpem::recordings
