#include "app/verbs/solve_speeds.hpp"

#include "app/progress_bar.hpp"
#include "app/schema/read_table.hpp"
#include "pem/lines/judged_case.hpp"

namespace railpem::app {

std::vector<ResponseSpectra> solve_speeds(const CaseFile& file, int threads) {
    const std::vector<double>& speeds = file.parameters.running.speeds_m_per_s;
    ProgressBar bar(file.name);
    std::vector<ResponseSpectra> spectra;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        const auto progress = [&](std::size_t done, std::size_t all) { bar.show(i * all + done, speeds.size() * all); };
        try {
            spectra.push_back(response_spectra(
                pem::solve_judged(file.parameters, speeds[i], {.threads = threads, .progress = progress})));
        } catch (const parameters::ParameterError& error) {
            throw refused(file.document, error);
        }
    }
    return spectra;
}

}  // namespace railpem::app
