#pragma once
// Whether a name stands together with an unknown that explains more than it.

#include "diagnosis/judge/verdict.hpp"
#include "diagnosis/search/inquiry.hpp"

namespace railpem::diagnosis {

/// What an unknown outdoes may still stand beside it, if both together outdo the unknown alone: of a bump stop friction
/// and a rougher track were all that could be named, and neither was there. Or if it has most of what an unknown of its
/// own place explains: dampers of the rail to 3 kHz were, with 10 of 14 nats. Into `study.named_stands`.
void weigh_named_with_unknown(const Inquiry& inquiry, NamingResult& naming, PlaceStudy& study);

}  // namespace railpem::diagnosis
