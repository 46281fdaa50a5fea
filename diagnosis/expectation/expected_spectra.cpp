#include "diagnosis/expectation/expected_spectra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "diagnosis/expectation/expectation_settings.hpp"
#include "diagnosis/expectation/faint_sources.hpp"
#include "diagnosis/expectation/friction_spectra.hpp"
#include "diagnosis/expectation/kernel_smoothing.hpp"
#include "diagnosis/expectation/source_spectra.hpp"
#include "pem/coupling/excitation.hpp"
#include "pem/coupling/excite.hpp"
#include "pem/coupling/linearise.hpp"
#include "pem/coupling/wheel_transfers.hpp"

namespace railpem::diagnosis {

recordings::KernelWeights expectation_weights(const recordings::WindowKernel& kernel, int oversampling) {
    return recordings::kernel_weights(kernel, oversampling, kExpectationSettings.kernel_reach_bins);
}

namespace {

using Complex = std::complex<double>;

/// The coarse grid of the transfers, which covers the fine one.
struct TransferGrid {
    double from_hz, step_hz;
    std::size_t lines;
};

/// Half-power width of the narrowest mode of the vehicle, Hz. Modes so heavy or masses so light that nothing feels them
/// (a probe of the screening) do not count: a probe is held against the case without it, on the same grid.
double narrowest_mode(const vehicle::VehicleParameters& vehicle) {
    const double felt = kExpectationSettings.least_felt_mass;
    double narrowest = 1e300;
    for (const vehicle::BodyBendingMode& mode : vehicle.body_bending)
        if (vehicle.body_mass_kg > felt * mode.modal_mass_kg)
            narrowest = std::min(narrowest, 2.0 * mode.damping_ratio * mode.frequency_hz);
    for (const vehicle::WheelsetBendingMode& mode : vehicle.wheelset_bending)
        if (vehicle.wheelset_mass_kg > felt * mode.modal_mass_kg)
            narrowest = std::min(narrowest, 2.0 * mode.damping_ratio * mode.frequency_hz);
    for (const vehicle::BogieMountedMass& mass : vehicle.bogie_mounted_masses)
        if (mass.mass_kg > felt * vehicle.bogie_mass_kg)
            narrowest = std::min(narrowest, 2.0 * mass.damping_ratio * mass.frequency_hz);
    return narrowest;
}

TransferGrid transfer_grid(const pem::CaseParameters& parameters, const FineGrid& grid,
                           const ExpectationOptions& options) {
    const double width = narrowest_mode(parameters.vehicle);
    const double finest = kExpectationSettings.finest_step * options.transfer_step_hz;
    double step = options.transfer_step_hz;
    while (step > width / kExpectationSettings.lines_per_width && step > finest) step *= 0.5;
    const double from = std::max(options.transfer_step_hz, grid.frequency(0) - 2.0 * options.transfer_step_hz);
    return {from, step, static_cast<std::size_t>((grid.frequency(grid.count) - from) / step) + 4};
}

/// The rail on that grid. What hangs on it or bends below it may be as narrow as the vehicle's modes; a rail on pads is
/// not, and is solved at every few lines only.
std::vector<pem::RailGroup> channel_rails(const pem::CaseParameters& parameters, const pem::CoupledModel& model,
                                          const pem::RollingTable& rolling, const TransferGrid& grid,
                                          const ExpectationOptions& options) {
    const bool narrow = !parameters.track.rail_dampers.empty() || !parameters.track.support.bending_modes.empty();
    const int every =
        static_cast<int>(std::lround(options.transfer_step_hz / grid.step_hz)) * (narrow ? 1 : options.rail_every);
    if (!narrow && model.rail->equal_seats())
        return pem::rolling_rails(rolling, model, grid.from_hz, grid.step_hz, grid.lines, every, options.threads);
    return pem::rail_groups(model, grid.from_hz, grid.step_hz, grid.lines, every, options.threads);
}

/// The transfers from the four wheels to all channels on a coarse grid that covers the fine one, sensors included.
pem::WheelTransfers channel_transfers(const pem::CaseParameters& parameters, const pem::CoupledModel& model,
                                      const std::vector<ObservedChannel>& channels, const FineGrid& grid,
                                      const ExpectationOptions& options, std::vector<pem::RailGroup>* rails) {
    const auto [from, step, lines] = transfer_grid(parameters, grid, options);
    std::vector<std::size_t> responses;
    for (const ObservedChannel& channel : channels) responses.push_back(channel.response);
    pem::WheelTransfers transfers = pem::wheel_transfers(model, from, step, lines, responses, options.threads, rails);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const bool plain =
            channels[c].integrations == 0 && parameters.sensors.empty() && parameters.modifiers.sensors.empty();
        for (std::size_t line = 0; !plain && line < lines; ++line) {
            const Complex factor = channel_factor(parameters, channels[c], from + static_cast<double>(line) * step);
            for (std::size_t j = 0; j < 4; ++j) transfers.values[(line * channels.size() + c) * 4 + j] *= factor;
        }
    }
    return transfers;
}

/// Where a similar case's friction settled, linearising begins.
void start_near(const vehicle::FrictionDamping& known, const pem::CaseParameters& parameters,
                pem::CoupledModel& model) {
    if (parameters.vehicle.primary.friction_force_n > 0.0) model.car.friction.primary = known.primary;
    if (parameters.vehicle.secondary.friction_force_n > 0.0) model.car.friction.secondary = known.secondary;
}

/// What the irregularity's forces are felt as at other frequencies.
void add_modulation(const pem::CaseParameters& parameters, double speed, bool of_equal_seats, ExpectationCache& own) {
    own.orders = pem::modulations(parameters, own.track, own.modulation, kExpectationSettings.least_order);
    if (!of_equal_seats) std::erase_if(own.orders, [](const pem::Modulation& order) { return order.bays != 0; });
    std::vector<pem::Modulation> all = own.orders;
    for (const pem::Modulation& random : pem::random_modulations(own.track, own.modulation, speed))
        all.push_back(random);
    if (all.empty()) return;
    own.felt = pem::felt_orders(all, own.modulation);
    own.of_irregularity = with_what_comes_back(own.transfers, own.felt.front());
}

bool has_forces(const pem::CaseParameters& parameters) {
    return has_friction(parameters) || has_own_forces(parameters);
}

/// What does not depend on the excitation, or is costly. Forces of the suspension's own are added to `expected` at
/// once.
ExpectationCache prepared(const pem::CaseParameters& parameters, double speed,
                          const std::vector<ObservedChannel>& channels, const FineGrid& grid, double bin_hz,
                          const ExpectationOptions& options, const ExpectationCache* known, Reuse reuse,
                          ExpectedSpectra& expected) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const bool same_rail = reuse == Reuse::rail;
    ExpectationCache own;
    pem::CoupledModel model =
        same_rail && known->rail ? pem::coupled_model(parameters, known->rail) : pem::coupled_model(parameters, speed);
    own.rail = model.rail;
    pem::RollingTable rolling =
        same_rail ? known->modulation.rolling
                  : pem::rolling_table(model, speed, pem::modulation_end_hz(parameters, speed),
                                       known && !options.sharp ? &known->modulation.rolling : nullptr);
    std::vector<pem::Source> sources;
    if (pem::is_nonlinear(parameters)) {
        sources = pem::excitation_sources(parameters, wheels, speed);
        own.level_rails = same_rail && !known->level_rails.empty()
                              ? known->level_rails
                              : pem::linearisation_rails(parameters, model, rolling);
        if (known) start_near(known->friction, parameters, model);
        pem::linearise(parameters, sources, model, &own.level_rails);
    }
    const TransferGrid lines = transfer_grid(parameters, grid, options);
    own.rails = same_rail && known->transfers.lines == lines.lines
                    ? known->rails
                    : channel_rails(parameters, model, rolling, lines, options);
    own.transfers = channel_transfers(parameters, model, channels, grid, options, &own.rails);
    const SolvedLines solved{model, own.rails, lines.from_hz, lines.step_hz, lines.lines};
    if (has_friction(parameters))
        add_friction(parameters, solved,
                     {sources, own.level_rails, options.friction_power, options.realised_friction.get()}, channels,
                     bin_hz, expected);
    if (options.realised_friction)
        follow_damping(parameters, solved, *options.realised_friction, channels, own.transfers);
    if (has_own_forces(parameters)) add_own_forces(parameters, solved, channels, bin_hz, expected);
    if (has_forces(parameters)) own.forces = expected.values;
    own.friction = model.car.friction;
    own.pads = pem::pad_transfers(parameters, model, same_rail && !known->pads.rail.empty() ? &known->pads : nullptr);
    own.track = same_rail ? pem::with_other_vehicle(known->track, parameters, model, speed, options.sharp)
                          : pem::track_excitation(parameters, wheels, speed, &model, options.sharp);
    own.of_irregularity = own.transfers;
    own.sensors = parameters.sensors;
    own.sensor_factors = parameters.modifiers.sensors;
    if (!model.rail->equal_seats()) return own;
    own.modulation = pem::modulation_transfers(parameters, model, speed, std::move(rolling),
                                               same_rail ? &known->modulation : nullptr);
    add_modulation(parameters, speed, options.sharp, own);
    pem::feed_back_lines(parameters, own.modulation, own.track);
    return own;
}

/// What forces of the suspension's own add, as other sensors see it.
void see_forces(const std::vector<ObservedChannel>& channels, const pem::CaseParameters& before,
                const pem::CaseParameters& parameters, double bin_hz, std::size_t first_bin, ExpectationCache& own) {
    const std::size_t size = channels.size();
    std::vector<Complex> seen(size);
    for (std::size_t at = 0, bin = first_bin; at < own.forces.size(); at += size * size, ++bin) {
        const double frequency = static_cast<double>(bin) * bin_hz;
        for (std::size_t c = 0; c < size; ++c)
            seen[c] =
                channel_factor(parameters, channels[c], frequency) / channel_factor(before, channels[c], frequency);
        for (std::size_t j = 0; j < size; ++j)
            for (std::size_t i = 0; i < size; ++i) own.forces[at + j * size + i] *= seen[i] * std::conj(seen[j]);
    }
}

/// The cache of a case whose sensors alone are others.
ExpectationCache with_other_sensors(const ExpectationCache& known, const pem::CaseParameters& parameters,
                                    const std::vector<ObservedChannel>& channels, double bin_hz,
                                    std::size_t first_bin) {
    pem::CaseParameters before = parameters;
    before.sensors = known.sensors;
    before.modifiers.sensors = known.sensor_factors;
    ExpectationCache own = known;
    own.sensors = parameters.sensors;
    own.sensor_factors = parameters.modifiers.sensors;
    see_forces(channels, before, parameters, bin_hz, first_bin, own);
    for (std::size_t c = 0; c < channels.size(); ++c)
        for (std::size_t line = 0; line < known.transfers.lines; ++line) {
            const double frequency = known.transfers.from_hz + static_cast<double>(line) * known.transfers.step_hz;
            const Complex now = channel_factor(parameters, channels[c], frequency),
                          then = channel_factor(before, channels[c], frequency);
            if (now == then) continue;
            for (std::size_t j = 0; j < 4; ++j) {
                own.transfers.values[(line * channels.size() + c) * 4 + j] *= now / then;
                own.of_irregularity.values[(line * channels.size() + c) * 4 + j] *= now / then;
            }
        }
    return own;
}

/// `irregularity`: its powers on the fine grid.
void add_broadband(const pem::CaseParameters& parameters, const pem::Excitation& excitation,
                   const MetPowers& irregularity, double speed, const ExpectationCache& parts, const FineGrid& grid,
                   double bin, const recordings::KernelWeights& weights, const ExpectationOptions& options,
                   ExpectedSpectra& expected) {
    const SpeedMixture* speeds = options.speeds.get();
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    for (const pem::DelayedSpectrum& source : excitation.broadband) {
        const bool first = &source == &excitation.broadband.front();
        const std::vector<double> power = first ? irregularity.at_lines : powers_at_lines(source, grid, speeds);
        add_smoothed(
            fine_responses(parts.of_irregularity, source, power, wheels, speed, grid, speeds), expected.channels,
            weights,
            {.first = grid.first, .count = grid.count, .first_bin = expected.first_bin, .bins = expected.bins()},
            expected.values);
    }
    std::vector<pem::DelayedSpectrum> faint = pem::pad_distortion(parts.pads, excitation.broadband, wheels, speed);
    std::ranges::move(pem::distortion_sources(options.contacts, parameters), std::back_inserter(faint));
    add_as_they_are(parts.transfers, faint, wheels, speed, bin, expected);
    if (parameters.modifiers.has_met_alone())
        add_met_alone(parameters, parts.transfers, excitation.broadband.front(), wheels, speed, bin, expected);
    add_felt(parts.transfers, parts.felt, excitation.broadband.front(), wheels, speed, bin, expected);
}

void add_all_lines(const pem::CaseParameters& parameters, const pem::Excitation& excitation,
                   const ExpectationCache& parts, const recordings::WindowKernel& kernel, const SpeedMixture* speeds,
                   ExpectedSpectra& expected) {
    // Of wheels out of round what supports make of them: lines of joints hardly stand above the irregularity, those of
    // passing supports act on each other (feed_back_lines).
    for (const pem::LineSet& set : excitation.lines) {
        const bool modulated = set.name.starts_with("wheel_") && !parts.felt.empty();
        add_lines(parameters, parts.transfers, modulated ? pem::felt_lines(parts.felt, set) : set, kernel, speeds,
                  expected);
    }
}

}  // namespace

ExpectedSpectra expected_spectra(const pem::CaseParameters& parameters, double speed,
                                 const recordings::WindowKernel& kernel, const std::vector<ObservedChannel>& channels,
                                 const std::vector<double>& noise_psd, const ExpectationOptions& options,
                                 const ExpectationCache* known, Reuse reuse, ExpectationCache* filled) {
    const double bin = kernel.bin_hz();
    ExpectedSpectra expected{.channels = channels.size()};
    expected.first_bin = static_cast<std::size_t>(std::ceil(options.low_hz / bin));
    const std::size_t bins = static_cast<std::size_t>(options.high_hz / bin) - expected.first_bin + 1;
    expected.values.assign(bins * channels.size() * channels.size(), 0.0);
    const FineGrid grid = fine_grid(kernel, expected.first_bin, bins, options.oversampling);
    const recordings::KernelWeights weights =
        options.weights.weights.empty() ? expectation_weights(kernel, options.oversampling) : options.weights;
    // With all transfers the excitation's lines are those of the cache; pads that stiffen under load do not share it.
    ExpectationCache own;
    if (reuse == Reuse::motion)
        own = with_other_sensors(*known, parameters, channels, bin, expected.first_bin);
    else if (reuse < Reuse::motion)
        own = prepared(parameters, speed, channels, grid, bin, options, known, reuse, expected);
    const ExpectationCache& parts = reuse >= Reuse::transfers ? *known : own;
    if (reuse >= Reuse::motion && !parts.forces.empty()) expected.values = parts.forces;
    const pem::Excitation excitation =
        pem::excitation(parameters, vehicle::wheel_positions(parameters.vehicle), speed, &parts.track);
    const MetPowers irregularity = met_powers(parameters, excitation.broadband.front(), speed, grid,
                                              known ? &known->powers : nullptr, options.speeds.get());
    if (reuse == Reuse::broadband && parts.broadband.size() == expected.values.size())
        expected.values = parts.broadband;
    else
        add_broadband(parameters, excitation, irregularity, speed, parts, grid, bin, weights, options, expected);
    if (filled) own.broadband = expected.values, own.powers = irregularity;
    add_all_lines(parameters, excitation, parts, kernel, options.speeds.get(), expected);
    if (filled && reuse < Reuse::transfers) *filled = std::move(own);
    add_sensor_noise(parameters, channels, bin, expected);
    for (std::size_t b = 0; b < bins; ++b)
        for (std::size_t c = 0; c < channels.size() && !noise_psd.empty(); ++c)
            expected.values[b * channels.size() * channels.size() + c * (channels.size() + 1)] += noise_psd[c];
    return expected;
}

std::vector<double> whitened_trace(const ExpectedSpectra& expected, const recordings::CrossSpectra& measured,
                                   const std::vector<ObservedChannel>& channels) {
    const long size = static_cast<long>(channels.size());
    std::vector<double> trace;
    Eigen::MatrixXcd kept(size, size);
    for (std::size_t b = 0; b < expected.bins(); ++b) {
        for (long i = 0; i < size; ++i)
            for (long j = 0; j < size; ++j)
                kept(i, j) = measured.at(expected.first_bin + b, channels[static_cast<std::size_t>(i)].channel,
                                         channels[static_cast<std::size_t>(j)].channel);
        const Eigen::MatrixXcd model = expected.matrix(b);
        trace.push_back(model.llt().solve(kept).trace().real() / static_cast<double>(size));
    }
    return trace;
}

}  // namespace railpem::diagnosis
