#pragma once
// Everything that is wrong with a file, where one refusal is not enough.

#include <string>
#include <vector>

#include "app/input_error.hpp"

namespace railpem::app {

using Refusals = std::vector<InputError>;

/// How much of what is wrong a reader says before it gives up.
enum class Refuse { first, all };

/// Runs `step`; what it refuses is thrown, or added to `all` where there is one. Tells whether nothing was refused.
template <class Step>
bool guarded(Refusals* all, const Step& step) {
    if (!all) return step(), true;
    try {
        step();
        return true;
    } catch (const InputError& error) {
        all->push_back(error);
        return false;
    }
}

/// Throws all of them as one, in the order in which they were found; nothing when there is none.
inline void throw_all(const Refusals& all) {
    if (all.empty()) return;
    if (all.size() == 1) throw all.front();
    std::string text;
    for (const InputError& error : all) text += std::string(error.what()) + "\n\n";
    throw InputError(text + std::to_string(all.size()) + " errors");
}

}  // namespace railpem::app
