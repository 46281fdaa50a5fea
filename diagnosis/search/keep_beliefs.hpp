#pragma once
// What only gives up beliefs, held against the case that keeps them.

#include "diagnosis/judge/verdict.hpp"
#include "diagnosis/search/inquiry.hpp"

namespace railpem::diagnosis {

/// Takes those sets out of `naming` that give up beliefs which the unseen part of the recordings bears out, and notes
/// them in `study`, with the case that keeps what the best set gives up.
void keep_beliefs(const Inquiry& inquiry, NamingResult& naming, PlaceStudy& study);

}  // namespace railpem::diagnosis
