// Compiled for any processor, and run before everything else: the rest of the program uses instructions that a machine
// other than the one it was built on may not have.

#include <unistd.h>

namespace {

#ifdef RAILPEM_PROCESSOR_FITS  // scripts/processor.cmake

// 101: the first that programs may ask for; statically initialised tables come later.
__attribute__((constructor(101))) void require_processor() {
    constexpr char kMessage[] = "railpem: this build needs a processor of the kind " RAILPEM_PROCESSOR
                                ", which this machine does not have; build it here, or with -DRAILPEM_MARCH= for any\n";
    __builtin_cpu_init();
    if (RAILPEM_PROCESSOR_FITS) return;
    static_cast<void>(!write(STDERR_FILENO, kMessage, sizeof kMessage - 1));
    _exit(2);
}

#endif

}  // namespace
