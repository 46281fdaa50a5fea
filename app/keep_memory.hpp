#pragma once
// How memory is asked for.

namespace railpem::app {

/// Keeps what is freed for what is asked for next, where the C library is glibc: cross-spectra of a megabyte come and
/// go by the thousand, and giving each back to the system and having its pages zeroed anew took an eighth of a
/// diagnosis (docs/speed.md). At most a gigabyte is kept.
void keep_memory();

}  // namespace railpem::app
