#pragma once
// Free complex corrections: what a place of the structure would have to be like, without a name for it.

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/screen.hpp"

namespace railpem::diagnosis {

/// A place that can be given a free correction.
struct CorrectionPlace {
    Element element = Element::body;
    std::string channel;  ///< sensor only: as the effects call it
    int which = 0;        ///< bogie and wheel only: that one alone, numbered from the front; 0: all of them
    /// Body and bogie only: on the body heave, pitch and what couples them each by itself, instead of one factor on the
    /// inertia; of bogies what acts between the two.
    bool attached = false;
    /// Suspension: beside the factor, forces of its own, incoherent from element to element: what no linear law leaves
    /// (stops, play, stick). Pad: only what each wheel meets by itself (pem::WheelsOwn): seats that are not alike,
    /// play, ground that changes along the line (support, once that is told apart).
    bool forces = false;
};

/// What each wheel meets by itself, and no factor.
bool is_wheels_own(const CorrectionPlace& place);

/// What the free correction of a place multiplies its law with at ω (rad/s), 1 when it has none; attached: the dynamic
/// mass against heave.
std::complex<double> correction_at(const pem::CaseParameters& parameters, const CorrectionPlace& place, double omega);

/// Places of the case that the recordings could speak of.
std::vector<CorrectionPlace> correction_places(const BelievedCase& believed,
                                               const std::vector<Observation>& observations);

/// Unknowns of a correction: real and imaginary part at nodes over the common band. Structure: the complex factor on
/// the dynamic stiffness (suspension, pad, support, contact) or dynamic mass (body, bogie, wheel, rail); attached:
/// dynamic masses at the centre, the front and the rear, in multiples of the body's (vehicle::Attachments); sensor: on
/// the transfer of a channel; forces: a third part, in multiples of force_reference(), never negative (pad: the only
/// one, a share of the irregularity's power); irregularity: a power factor fixed in frequency, which no irregularity
/// can have.
std::vector<Unknown> correction_unknowns(const CorrectionPlace& place, const std::vector<Observation>& observations);

/// How much the node of a part of a correction (of correction_unknowns() at one node, in their order) moves it at a
/// frequency (Hz): 1 at the node itself, 0 at all others. `nodes` of correction_nodes().
double correction_weight(const CorrectionPlace& place, std::size_t part, const std::vector<double>& nodes,
                         std::size_t node, double frequency_hz);

/// Frequencies of the nodes, Hz.
std::vector<double> correction_nodes(const CorrectionPlace& place, const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis
