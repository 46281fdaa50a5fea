#pragma once
// The excitation that a case asks for at a speed.

#include <string>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/excitation.hpp"

namespace railpem::pem {

/// `model`: of the case at this speed; with it the lines of passing sleepers have what their own forces do
/// (passing_feedback.hpp), unless `fed_back` is false.
TrackExcitation track_excitation(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                 double speed_m_per_s, const CoupledModel* model = nullptr, bool fed_back = true);

/// The same under another vehicle, whose forces it feels: of the track and speed of `known`, which does not stiffen
/// under load.
TrackExcitation with_other_vehicle(const TrackExcitation& known, const CaseParameters& parameters,
                                   const CoupledModel& model, double speed_m_per_s, bool fed_back = true);

/// The same for another load and amplitude factor. The track must be the same and not stiffen under load; throws
/// nothing.
TrackExcitation rescaled(const TrackExcitation& known, const CaseParameters& parameters);

/// `known`: the track's part, if it is known already; else made, with `model` as in track_excitation().
Excitation excitation(const CaseParameters& parameters, const std::vector<double>& wheels_m, double speed_m_per_s,
                      const TrackExcitation* known = nullptr, const CoupledModel* model = nullptr);

/// The excitation as sources on a frequency grid: e_j = exp(−iω·d_j/v)·√S(f) for the broadband ones (Lin's
/// pseudo-excitation; Wei et al. 2016, section 4.1). `model` as in track_excitation().
std::vector<Source> excitation_sources(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                       double speed_m_per_s, const CoupledModel* model = nullptr);

}  // namespace railpem::pem
