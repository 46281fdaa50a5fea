#pragma once
// Many cases: parameters varied over a design, a few quantities of each case kept.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pem/case_parameters.hpp"

namespace railpem::pem {

/// How the values of the varied parameters are combined. grid: every combination, the last parameter fastest; list: the
/// n-th values of all parameters together; latin_hypercube: `samples` points, one in each of `samples` strata of every
/// parameter.
enum class Design { grid, list, latin_hypercube };

/// One varied parameter.
struct SweepAxis {
    std::string key;
    std::function<void(CaseParameters&, double)> set;
    std::vector<double> values;    ///< grid and list
    double low = 0.0, high = 0.0;  ///< latin_hypercube
    bool logarithmic = false;      ///< strata equal in the logarithm
};

/// The last three are of ride comfort (spectra/comfort.hpp) and need a response of the body and lines that cover 0.5 to
/// 80 Hz.
enum class QuantityKind {
    rms,
    peak_level,
    peak_frequency,
    bands,
    spectrum,
    weighted_rms_iso2631,
    mean_comfort_en12299,
    sperling_index
};

/// What is kept of a response: one number, or one per third-octave or line.
struct SweepQuantity {
    std::string response;
    QuantityKind kind = QuantityKind::rms;
};

/// One row of the table of every case.
struct SweepRow {
    double speed_m_per_s;
    /// with its unit: "rms_m_per_s2", "peak_level_m2_per_s4_per_hz", "peak_frequency_hz", "level_db", "psd_…"
    std::string quantity;
    std::string response;
    double frequency_hz;  ///< of the band or line; NaN for a quantity of the whole spectrum
};

/// Mean square of a third-octave from a PSD on the lines of the sweep, and the centres of the bands that the lines
/// cover; given by the caller, who knows the bands.
struct BandRule {
    std::vector<double> centre_hz;
    std::function<std::vector<double>(const std::vector<double>& frequency_hz, const std::vector<double>& psd)> levels;
};

struct SweepPlan {
    CaseParameters base;
    Design design = Design::grid;
    std::vector<SweepAxis> axes;
    std::vector<SweepQuantity> quantities;
    std::size_t samples = 0;  ///< latin_hypercube
    std::uint64_t seed = 1;
    BandRule bands;
};

/// Number of cases of the plan.
std::size_t sweep_size(const SweepPlan& plan);

/// Values of the varied parameters of case `index`, in the order of the axes. Any case can be asked for at any time:
/// nothing is stored per case (the Latin hypercube permutes by a keyed bijection).
std::vector<double> sweep_values(const SweepPlan& plan, std::size_t index);

/// The case itself. Not checked.
CaseParameters sweep_case(const SweepPlan& plan, std::size_t index);

/// The rows that every case has, in order. The varied parameters must not change the number of lines or speeds.
std::vector<SweepRow> sweep_rows(const SweepPlan& plan);

/// How a sweep runs. All are called from several threads at a time.
struct SweepObserver {
    std::function<bool(std::size_t index)> finished;  ///< cases to leave out
    /// the values of a case's rows, in order
    std::function<void(std::size_t index, const std::vector<double>& values)> done;
    /// what a case was warned of at one of its speeds; called before `done`
    std::function<void(std::size_t index, double speed_m_per_s, const std::vector<std::string>& warnings)> warned =
        nullptr;
    /// Which case comes next, nothing when all are given away: for a sweep that several processes share. Without it
    /// every case, in order.
    std::function<std::optional<std::size_t>()> next;
};

/// Runs every case that it is given and that is not finished. Cases run in parallel, each on one thread; with fewer
/// cases than threads the lines of each do. The same bits for any number of threads. Throws what a case throws
/// (parameters::ParameterError without a static equilibrium) or `done` throws; cases that were done stay done.
void run_sweep(const SweepPlan& plan, int threads, const SweepObserver& observer);

}  // namespace railpem::pem
