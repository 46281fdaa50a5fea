#pragma once

namespace railpem::app {

/// The program: reads the arguments, runs the verb, and turns what happens into an exit status: 0 done, 2 the input was
/// refused (one message on stderr), 1 anything else.
int run_program(int argc, const char* const* argv);

}  // namespace railpem::app
