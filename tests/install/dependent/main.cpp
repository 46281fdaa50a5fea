// Solves a case with the installed libraries and says how loud its first wheel is.
#include <cmath>
#include <cstdio>

#include "app/schema/case_file.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/coupling/solve_case.hpp"
#include "pem/response_names.hpp"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    try {
        const railpem::app::CaseFile file = railpem::app::read_case(argv[1], {"frequency.step_hz=1.0"});
        const railpem::pem::Solution solution =
            railpem::pem::solve_case(file.parameters, file.parameters.running.speeds_m_per_s.front());
        double power = 0.0;
        for (const double value : railpem::pem::response_psd(solution, railpem::pem::response_index("wheel_1")))
            power += value;
        std::printf("%s: wheel 1 has %.3g m/s2\n", file.name.c_str(), std::sqrt(power));
        return power > 0.0 ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
