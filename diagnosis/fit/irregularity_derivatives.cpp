#include "diagnosis/fit/irregularity_derivatives.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/expectation/kernel_smoothing.hpp"
#include "diagnosis/expectation/source_spectra.hpp"
#include "diagnosis/fit/imperfection_derivatives.hpp"
#include "diagnosis/fit/node_weight.hpp"
#include "diagnosis/model/effort.hpp"
#include "diagnosis/model/reuse.hpp"
#include "diagnosis/observations/channel_scales.hpp"
#include "pem/coupling/excitation.hpp"
#include "pem/coupling/excite.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;
using Values = std::vector<Complex>;

/// The irregularity and what it gives on the fine grid.
struct Given {
    const pem::DelayedSpectrum& source;
    FineGrid grid;
    std::vector<double> power;  ///< at every line
    Values responses;           ///< [rank][channel][line]
    bool of_many_speeds = false;
};

/// A weight at a fine line. Where a band begins or ends within the line's cell, the line's power is the mean over the
/// cell, and so is the weighted.
double weight_at(const NodeWeight& weight, const Given& given, std::size_t line) {
    const double f = given.grid.frequency(line), own = weight(f), centre = given.source.psd_m2_per_hz(f);
    if (given.of_many_speeds || given.power[line] == centre) return own;  // no edge is sharp at many speeds
    const pem::DelayedSpectrum weighted{
        .name = {}, .psd_m2_per_hz = [&](double g) { return weight(g) * given.source.psd_m2_per_hz(g); }};
    return power_over_cell(weighted, f, given.grid.step_hz, own * centre) / given.power[line];
}

/// What the irregularity gives at its own frequency, under one weight.
void add_weighted(const Given& given, const NodeWeight& weight, const recordings::KernelWeights& kernel,
                  const ExpectedSpectra& at, Values& sum) {
    const std::size_t channels = at.channels, size = channels * channels;
    const auto oversampling = static_cast<std::size_t>(kernel.oversampling),
               reach = static_cast<std::size_t>(kernel.reach_bins) * oversampling;
    std::size_t begin = 0, end = given.grid.count;
    while (begin < end && given.grid.frequency(begin + 1) <= weight.from_hz()) ++begin;
    while (end > begin && given.grid.frequency(end - 1) - given.grid.step_hz >= weight.to_hz()) --end;
    const std::size_t low = given.grid.first + begin, high = given.grid.first + end + reach;
    const std::size_t from = std::max(at.first_bin, low > reach ? (low - reach) / oversampling : 0),
                      to = std::min(at.first_bin + at.bins(), high / oversampling + 1);
    if (begin == end || from >= to) return;
    const std::size_t rows = given.responses.size() / given.grid.count;
    Values part(rows * (end - begin));
    for (std::size_t i = begin; i < end; ++i) {
        const double root = std::sqrt(weight_at(weight, given, i));
        for (std::size_t row = 0; row < rows; ++row)
            part[row * (end - begin) + i - begin] = root * given.responses[row * given.grid.count + i];
    }
    Values bins((to - from) * size, 0.0);
    add_smoothed(part, channels, kernel, {.first = low, .count = end - begin, .first_bin = from, .bins = to - from},
                 bins);
    for (std::size_t i = 0; i < bins.size(); ++i) sum[(from - at.first_bin) * size + i] += bins[i];
}

}  // namespace

bool has_irregularity_derivatives(const Trial& trial, const LikelihoodContext& context, std::size_t o,
                                  const Predictions& predictions) {
    const Observation& observation = (*context.observations)[o];
    const pem::CaseParameters parameters = case_of(trial, *context.believed, observation);
    return !observation.scalar && !predictions.caches.empty() &&
           shared_with(trial, Unknown{.kind = UnknownKind::irregularity}) == Reuse::transfers &&
           predictions.caches[o].pads.rail.empty() && parameters.irregularity.corrugation.empty() &&
           !parameters.irregularity.wave_correction.empty();
}

std::vector<Values> irregularity_derivatives(const Trial& trial, const std::vector<const Unknown*>& unknowns,
                                             const LikelihoodContext& context, std::size_t o,
                                             const Predictions& predictions) {
    const Observation& observation = (*context.observations)[o];
    const ExpectationCache& known = predictions.caches[o];
    const ExpectedSpectra& at = predictions.spectra[o];
    const pem::CaseParameters parameters = case_of(trial, *context.believed, observation);
    // all of them together
    if (context.effort)
        context.effort->add(
            effort_of_prediction(parameters, observation.bins(), Reuse::nothing, observation.expectation.sharp));
    const double speed = trial.speed_m_per_s[o];
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const pem::Excitation excitation = pem::excitation(parameters, wheels, speed, &known.track);
    const pem::DelayedSpectrum& irregularity = excitation.broadband.front();
    const ExpectationOptions options = expectation_of(observation, context.part);
    const FineGrid grid = fine_grid(observation.kernel, at.first_bin, at.bins(), options.oversampling);
    const recordings::KernelWeights kernel = options.weights.weights.empty()
                                                 ? expectation_weights(observation.kernel, options.oversampling)
                                                 : options.weights;
    const std::vector<double> at_lines =
        met_powers(parameters, irregularity, speed, grid, &known.powers, options.speeds.get()).at_lines;
    const Given given{
        irregularity, grid, at_lines,
        fine_responses(known.of_irregularity, irregularity, at_lines, wheels, speed, grid, options.speeds.get()),
        options.speeds != nullptr};
    std::vector<NodeWeight> weights;
    std::vector<Values> result;
    for (const Unknown* unknown : unknowns) {
        weights.emplace_back(parameters.irregularity.wave_correction.wavelength_m, unknown->index, speed);
        result.emplace_back(at.values.size(), 0.0);
        add_weighted(given, weights.back(), kernel, at, result.back());
    }
    const std::size_t size = at.channels;
    const auto add = [&](std::size_t bin, double from_hz, const Values& response) {
        for (std::size_t u = 0; u < weights.size(); ++u) {
            const double weight = weights[u](from_hz);
            Complex* power = result[u].data() + bin * size * size;
            for (std::size_t j = 0; weight > 0.0 && j < size; ++j)
                for (std::size_t i = 0; i < size; ++i)
                    power[j * size + i] += weight * response[i] * std::conj(response[j]);
        }
    };
    for_each_felt(known.transfers, known.felt, irregularity, wheels, speed, observation.kernel.bin_hz(), at, add);
    for (Values& values : result) scale_channels(trial.log_gain[o], values);
    // what wheels meet alone is a share of the irregularity
    const Values alone = met_alone_spectra(trial, context, o, predictions);
    for (std::size_t u = 0; u < weights.size(); ++u)
        for (std::size_t i = 0; i < alone.size(); ++i) {
            const double f = static_cast<double>(at.first_bin + i / (size * size)) * observation.kernel.bin_hz();
            result[u][i] += weights[u](f) * alone[i];
        }
    return result;
}

}  // namespace railpem::diagnosis
