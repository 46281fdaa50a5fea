#include "app/command_line.hpp"
#include "app/keep_memory.hpp"

int main(int argc, char** argv) {
    railpem::app::keep_memory();
    return railpem::app::run_program(argc, argv);
}
