// Loaded before a program (LD_PRELOAD), lets allocations fail: the RAILPEM_FAIL_AT-th, and with RAILPEM_FAIL_ON=1 every
// one after it. RAILPEM_COUNT_IN names a file that receives how many there were.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

std::atomic<long> count{0};
std::atomic<long> fail_at{0};
bool fail_on = false;

using Main = int (*)(int, char**, char**);
Main program_main = nullptr;

/// Counting begins where the program does: nothing can be done about memory that the loader and the libraries lack
/// before.
int counted_main(int argc, char** argv, char** environment) {
    if (const char* at = std::getenv("RAILPEM_FAIL_AT")) fail_at = std::atol(at);
    fail_on = std::getenv("RAILPEM_FAIL_ON") != nullptr;
    count = 0;
    return program_main(argc, argv, environment);
}

__attribute__((destructor)) void end() {
    const char* file = std::getenv("RAILPEM_COUNT_IN");
    if (!file) return;
    char text[32];
    const int length = std::snprintf(text, sizeof text, "%ld\n", count.load());
    const int descriptor = open(file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0 || write(descriptor, text, static_cast<std::size_t>(length)) != length) _exit(99);
    close(descriptor);
}

bool fails() {
    const long now = ++count, at = fail_at;
    if (at == 0 || (now != at && !(fail_on && now > at))) return false;
    errno = ENOMEM;
    return true;
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) noexcept {
    return fails() ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) noexcept {
    return fails() ? nullptr : __libc_calloc(number, size);
}
void* realloc(void* old, std::size_t size) noexcept {
    return fails() ? nullptr : __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return fails() ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return fails() ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
    if (fails()) return ENOMEM;
    *result = __libc_memalign(alignment, size);
    return *result ? 0 : ENOMEM;
}
}

extern "C" int __libc_start_main(Main own, int argc, char** argv, void (*begin)(), void (*finish)(), void (*unload)(),
                                 void* stack) {
    using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
    program_main = own;
    return reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"))(counted_main, argc, argv, begin, finish,
                                                                          unload, stack);
}
