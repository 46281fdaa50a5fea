#include "app/keep_memory.hpp"
#include "app/memory_shortage.hpp"
#include "app/verbs/command_line.hpp"

int main(int argc, char** argv) {
    railpem::app::keep_memory();
    railpem::app::end_on_memory_shortage();
    return railpem::app::run_program(argc, argv);
}
