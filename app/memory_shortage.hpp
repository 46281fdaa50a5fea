#pragma once
// What the program says when there is not enough memory.

namespace railpem::app {

/// Without asking for more of it.
void say_memory_shortage();

/// From now on the program ends with a word and status 1 where a library lacks memory and may not throw, too: toml++ builds its errors so.
void end_on_memory_shortage();

}  // namespace railpem::app
