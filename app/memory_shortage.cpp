#include "app/memory_shortage.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "app/output_folder.hpp"

namespace railpem::app {

void say_memory_shortage() {
    std::fputs("railpem: not enough memory\n", stderr);
}

void end_on_memory_shortage() {
    static std::terminate_handler otherwise = nullptr;
    otherwise = std::set_terminate([] {
        try {
            if (std::current_exception()) throw;
        } catch (const std::bad_alloc&) {
            say_memory_shortage();
            remove_unfinished_output();
            std::_Exit(EXIT_FAILURE);
        } catch (...) {  // for the one who was asked before
        }
        otherwise();
    });
}

}  // namespace railpem::app
