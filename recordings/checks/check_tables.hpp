#pragma once
// Recordings that are no time series: whether their numbers make sense.

#include <vector>

#include "recordings/checks/inspection_context.hpp"
#include "recordings/fault.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings::checks {

/// The rail of a track takes energy where it is struck (Im of the receptance < 0) and is a spring below its first
/// resonance (Re > 0). Its size is held against the case, or without one against what tracks have; mobility and
/// accelerance are told by their slope.
void check_receptance(const Recording& recording, const InspectionContext& context, std::vector<Fault>& faults);

/// Centres of decay rates against third-octaves, base ten and base two; their size as above.
void check_decay_rate(const Recording& recording, const InspectionContext& context, std::vector<Fault>& faults);

/// Spectra (kinds psd and points) against what the case predicts: unit and quantity, as check_unit() does.
void check_spectra(const Recording& recording, const InspectionContext& context, std::vector<Fault>& faults);

/// All of these.
std::vector<Fault> check_tables(const Recording& recording, const InspectionContext& context);

}  // namespace railpem::recordings::checks
