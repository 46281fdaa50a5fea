#pragma once
// What the program says when there is not enough memory.

namespace railpem::app {

/// Without asking for more of it.
void say_memory_shortage();

/// From now on the program ends with a word, status 1 and no unfinished output (remove_unfinished_output()) where a
/// library lacks memory and may not throw, too: toml++ and nlohmann::json have such places.
void end_on_memory_shortage();

}  // namespace railpem::app
