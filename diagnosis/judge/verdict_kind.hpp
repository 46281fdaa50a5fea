#pragma once

#include <string>

namespace railpem::diagnosis {

enum class Verdict { consistent, explained, ambiguous, unexplained, recording_fault };

/// "consistent", "recording-fault", …
std::string verdict_name(Verdict verdict);

}  // namespace railpem::diagnosis
