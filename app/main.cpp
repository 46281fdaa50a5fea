#include "app/command_line.hpp"
#include "app/keep_memory.hpp"
#include "app/memory_shortage.hpp"

int main(int argc, char** argv) {
    railpem::app::keep_memory();
    railpem::app::end_on_memory_shortage();
    return railpem::app::run_program(argc, argv);
}
