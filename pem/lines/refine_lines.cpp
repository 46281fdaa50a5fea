#include "pem/lines/refine_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace railpem::pem {

namespace {

constexpr double kTolerance = 0.01;   ///< of the mean square in a third-octave: half a per cent of its rms
constexpr double kWidestRatio = 1.5;  ///< of neighbouring lines: half an octave
constexpr int kLinesPerRipple = 4;    ///< of a cosine over frequency: twice what Nyquist asks for
constexpr double kNarrowest = 1e-6;   ///< interval over frequency: resolves damping ratios of 1e-5
constexpr double kNarrowestSeed = 1e-5;
constexpr double kBesideEdge = 1e-6;
constexpr double kApart = 0.25e-6;  ///< nearer lines are one
constexpr std::size_t kMostRefinedLines = 60000;

/// Lines that a seed asks for are put in where none is as near.
class LineGrid {
  public:
    explicit LineGrid(std::vector<double> lines) : lines_(std::move(lines)) {}

    /// Distance of the two lines around f; nothing to do outside of the grid.
    double spacing_at(double f) const {
        const auto above = std::upper_bound(lines_.begin(), lines_.end(), f);
        if (above == lines_.begin() || above == lines_.end()) return 0.0;
        return *above - *(above - 1);
    }
    /// f, and f ± reach·(1/2, 1, 2, 4 …) up to where the lines are as near.
    void surround(double f, double reach) {
        const double spacing = spacing_at(f);
        if (spacing <= reach) return;
        added_.push_back(f);
        for (double offset = 0.5 * reach; offset < spacing; offset *= 2.0)
            for (const double place : {f - offset, f + offset})
                if (spacing_at(place) > 0.25 * offset) added_.push_back(place);
    }
    void add(double f) {
        if (spacing_at(f) > 0.0) added_.push_back(f);
    }
    /// All lines, without those added that nearly coincide with another.
    std::vector<double> all() {
        std::sort(added_.begin(), added_.end());
        std::vector<double> result;
        std::size_t next = 0;
        const auto far_from_last = [&](double f) { return result.empty() || f - result.back() > kApart * f; };
        for (const double line : lines_) {
            for (; next < added_.size() && added_[next] < line; ++next)
                if (far_from_last(added_[next]) && line - added_[next] > kApart * line) result.push_back(added_[next]);
            result.push_back(line);
        }
        return result;
    }

  private:
    std::vector<double> lines_, added_;
};

std::vector<double> without_gaps(const std::vector<double>& given, double widest_hz) {
    std::vector<double> lines;
    for (std::size_t i = 0; i + 1 < given.size(); ++i) {
        const double a = given[i], b = given[i + 1];
        const int by_ripple = static_cast<int>(std::ceil((b - a) / widest_hz - 1e-9));
        const int by_ratio = static_cast<int>(std::ceil(std::log(b / a) / std::log(kWidestRatio) - 1e-9));
        lines.push_back(a);
        // Where the ratio is what is too wide, equal ratios put the lines where it is.
        for (int k = 1; k < std::max(by_ripple, by_ratio); ++k)
            lines.push_back(by_ripple >= by_ratio ? a + (b - a) * k / by_ripple
                                                  : a * std::pow(b / a, static_cast<double>(k) / by_ratio));
    }
    lines.push_back(given.back());
    return lines;
}

/// Lines with their spectra, and which of them have to be solved.
struct LineSpectra {
    std::vector<double> frequency_hz;
    std::vector<std::vector<double>> psd;
};

/// Puts `added` lines among the known ones and solves them; with teeth in the excitation also their neighbours, whose
/// bins have become narrower.
void insert_lines(const CaseParameters& parameters, const PreparedCase& prepared, const std::vector<double>& added,
                  const SolveOptions& options, LineSpectra& known) {
    const bool bins_matter = std::any_of(prepared.sources.begin(), prepared.sources.end(),
                                         [](const PreparedSource& own) { return !own.teeth_hz.empty(); });
    std::vector<double> merged;
    std::merge(known.frequency_hz.begin(), known.frequency_hz.end(), added.begin(), added.end(),
               std::back_inserter(merged));
    std::vector<bool> is_new(merged.size());
    for (std::size_t i = 0, k = 0; i < merged.size(); ++i)
        if (k < added.size() && merged[i] == added[k]) is_new[i] = true, ++k;
    const FrequencyLines bins = with_bins(merged);
    FrequencyLines asked;
    std::vector<std::size_t> place;
    for (std::size_t i = 0; i < merged.size(); ++i) {
        const bool beside = (i > 0 && is_new[i - 1]) || (i + 1 < merged.size() && is_new[i + 1]);
        if (!is_new[i] && !(beside && bins_matter)) continue;
        place.push_back(i);
        asked.frequency_hz.push_back(bins.frequency_hz[i]);
        asked.below_hz.push_back(bins.below_hz[i]);
        asked.above_hz.push_back(bins.above_hz[i]);
    }
    const Solution solved = solve_lines(parameters, prepared, asked, {options.threads, nullptr, options.interrupted});
    for (std::size_t response = 0; response < known.psd.size(); ++response) {
        std::vector<double> row(merged.size());
        for (std::size_t i = 0, k = 0; i < merged.size(); ++i)
            if (!is_new[i]) row[i] = known.psd[response][k++];
        const std::vector<double> own = response_psd(solved, response);
        for (std::size_t k = 0; k < place.size(); ++k) row[place[k]] = own[k];
        known.psd[response] = std::move(row);
    }
    known.frequency_hz = std::move(merged);
}

/// Where bands of wavelengths begin and end, Hz: the spectra may jump there.
std::vector<double> band_edges(const CaseParameters& parameters, double speed_m_per_s) {
    std::vector<double> edges;
    for (const spectra::IrregularityBand& band : parameters.irregularity.bands)
        for (const double wavelength : {band.shortest_wavelength_m, band.longest_wavelength_m})
            edges.push_back(speed_m_per_s / wavelength);
    return edges;
}

/// Intervals that hold nothing but the jump at an edge: their lines stand beside it.
std::vector<bool> jumps_between(const std::vector<double>& f, const std::vector<double>& edges) {
    std::vector<bool> jumps(f.size() - 1);
    for (const double edge : edges) {
        const double reach = 2.0 * kBesideEdge * edge;
        const auto first = std::lower_bound(f.begin(), f.end(), edge - reach);
        for (auto line = first; line != f.end() && line + 1 != f.end() && *(line + 1) <= edge + reach; ++line)
            jumps[static_cast<std::size_t>(line - f.begin())] = true;
    }
    return jumps;
}

/// What the trapezoid of each interval is off by: h³/12 times the second derivative there, in the mean of its ends. A
/// derivative does not reach across a jump, and a jump itself is not off.
std::vector<double> trapezoid_errors(const std::vector<double>& f, const std::vector<double>& psd,
                                     const std::vector<bool>& jumps) {
    const std::size_t n = f.size();
    std::vector<std::optional<double>> second(n);
    std::vector<double> errors(n - 1, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i)
        if (!jumps[i - 1] && !jumps[i])
            second[i] = 2.0 * ((psd[i + 1] - psd[i]) / (f[i + 1] - f[i]) - (psd[i] - psd[i - 1]) / (f[i] - f[i - 1])) /
                        (f[i + 1] - f[i - 1]);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        if (jumps[i] || (!second[i] && !second[i + 1])) continue;
        const double mean = 0.5 * (second[i].value_or(*(second[i + 1] ? second[i + 1] : second[i])) +
                                   second[i + 1].value_or(*(second[i] ? second[i] : second[i + 1])));
        errors[i] = std::pow(f[i + 1] - f[i], 3) / 12.0 * mean;
    }
    return errors;
}

struct Cell {
    double power = 0.0, error = 0.0, size = 0.0, largest = 0.0;
};

/// The index of the third-octave that holds most of an interval.
int cell_of(double low, double high) {
    return static_cast<int>(std::lround(10.0 * std::log10(0.5 * (low + high))));
}

/// Marks the intervals of a response that have to be halved.
void mark_doubtful(const std::vector<double>& f, const std::vector<double>& psd, const std::vector<bool>& jumps,
                   std::vector<bool>& marked) {
    const std::vector<double> errors = trapezoid_errors(f, psd, jumps);
    std::map<int, Cell> cells;
    for (std::size_t i = 0; i + 1 < f.size(); ++i) {
        Cell& cell = cells[cell_of(f[i], f[i + 1])];
        cell.power += 0.5 * (psd[i] + psd[i + 1]) * (f[i + 1] - f[i]);
        cell.error += errors[i];
        cell.size += std::abs(errors[i]);
        cell.largest = std::max(cell.largest, std::abs(errors[i]));
    }
    for (std::size_t i = 0; i + 1 < f.size(); ++i) {
        const Cell& cell = cells[cell_of(f[i], f[i + 1])];
        // Errors of either sign cancel, as those of a ripple do; only part of that is relied on.
        const bool doubtful =
            std::abs(cell.error) > kTolerance * cell.power || cell.size > 10.0 * kTolerance * cell.power;
        if (doubtful && std::abs(errors[i]) >= 0.1 * cell.largest) marked[i] = true;
    }
}

}  // namespace

std::vector<double> starting_lines(const CaseParameters& parameters, const PreparedCase& prepared,
                                   const std::vector<double>& given) {
    const double speed = prepared.speed_m_per_s;
    const std::vector<double>& wheels = prepared.model.wheels_m;
    LineGrid grid(without_gaps(given, speed / (wheels.front() - wheels.back()) / kLinesPerRipple));
    for (const Resonance& resonance : natural_resonances(prepared))
        grid.surround(resonance.frequency_hz,
                      std::max(0.5 * resonance.width_hz, kNarrowestSeed * resonance.frequency_hz));
    for (const Resonance& tooth : excitation_teeth(parameters, prepared))
        grid.surround(tooth.frequency_hz, 0.5 * tooth.width_hz);
    for (const double edge : band_edges(parameters, speed)) {
        grid.add(edge * (1.0 - kBesideEdge));
        grid.add(edge * (1.0 + kBesideEdge));
    }
    return grid.all();
}

RefinedSpectra refine_lines(const CaseParameters& parameters, const PreparedCase& prepared, const Solution& start,
                            const SolveOptions& options) {
    LineSpectra known{start.frequency_hz, {}};
    for (std::size_t response = 0; response < response_names().size(); ++response)
        known.psd.push_back(response_psd(start, response));
    const std::vector<double> wanted = starting_lines(parameters, prepared, start.frequency_hz);
    std::vector<double> added;
    std::set_difference(wanted.begin(), wanted.end(), start.frequency_hz.begin(), start.frequency_hz.end(),
                        std::back_inserter(added));
    const std::vector<double> edges = band_edges(parameters, prepared.speed_m_per_s);
    RefinedSpectra result;
    for (;;) {
        if (!added.empty()) insert_lines(parameters, prepared, added, options, known);
        const std::vector<double>& f = known.frequency_hz;
        std::vector<bool> marked(f.size() - 1);
        const std::vector<bool> jumps = jumps_between(f, edges);
        for (const std::vector<double>& psd : known.psd) mark_doubtful(f, psd, jumps, marked);
        added.clear();
        for (std::size_t i = 0; i + 1 < f.size(); ++i) {
            if (!marked[i]) continue;
            if (f[i + 1] - f[i] > kNarrowest * f[i])
                added.push_back(0.5 * (f[i] + f[i + 1]));
            else if (result.converged)
                result.converged = false, result.doubtful_hz = f[i];
        }
        if (added.empty() || !result.converged) break;
        if (f.size() + added.size() > start.frequency_hz.size() + kMostRefinedLines) {
            result.converged = false;
            result.doubtful_hz = added.front();
            break;
        }
    }
    result.frequency_hz = std::move(known.frequency_hz);
    result.psd = std::move(known.psd);
    return result;
}

}  // namespace railpem::pem
