// Compiled for any processor, and run before everything else: the rest of the program uses instructions that a machine other than the one it was built on may not have.

#include <unistd.h>

#include <cstring>

namespace {

#if defined(RAILPEM_PROCESSOR) && (defined(__x86_64__) || defined(__i386__))

bool has_processor() {
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
    if (std::strcmp(RAILPEM_PROCESSOR, "x86-64-v4") != 0) return v3 || std::strcmp(RAILPEM_PROCESSOR, "x86-64-v3") != 0;
    return v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}

// 101: the first that programs may ask for; statically initialised tables come later.
__attribute__((constructor(101))) void require_processor() {
    constexpr char kMessage[] = "railpem: this build needs a processor of the kind " RAILPEM_PROCESSOR ", which this machine does not have; build it here, or with -DRAILPEM_MARCH= for any\n";
    __builtin_cpu_init();
    if (has_processor()) return;
    static_cast<void>(!write(STDERR_FILENO, kMessage, sizeof kMessage - 1));
    _exit(2);
}

#endif

}  // namespace
