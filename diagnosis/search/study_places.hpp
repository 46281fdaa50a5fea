#pragma once
// Where in the structure something is missing.

#include <vector>

#include "diagnosis/judge/verdict.hpp"
#include "diagnosis/search/inquiry.hpp"

namespace railpem::diagnosis {

/// How a free correction is fitted in full.
inline constexpr int kAnonymousIterations = 12;
inline constexpr double kAnonymousGain = 1.0;  ///< nats: a score that decides between names within 3 needs no more

/// What free corrections would explain beside the retuned case and beside the best set, what either misses, how well
/// the best set holds, and the free corrections of the most telling places fitted in full, into `study`. What `naming`
/// knows already of it is not asked again.
void study_places(const Inquiry& inquiry, NamingResult& naming, PlaceStudy& study);

/// What the best set leaves, by place, best first; asked once.
const std::vector<LocatedEvidence>& left_by_best(const Inquiry& inquiry, NamingResult& naming);

/// Whether a member of the set sits at that element.
bool sits_at(const FittedSet& set, Element element);

/// Whether a multiple of the effort that the search is allowed is spent.
bool is_spent(const Inquiry& inquiry, double times);

}  // namespace railpem::diagnosis
