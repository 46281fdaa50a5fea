#include "pem/coupling/linearise.hpp"

#include <algorithm>
#include <cmath>

#include "pem/angular_frequency.hpp"
#include "pem/contact.hpp"
#include "pem/coupling/wheel_transfers.hpp"
#include "pem/gaussian_mean.hpp"
#include "track/statics/anderson_mixing.hpp"

namespace railpem::pem {

namespace {

constexpr int kMostIterations = 200;
constexpr double kSettled = 1e-12;  ///< differences of 1e-7 are taken of what follows from it
constexpr double kRounding = 1e-8;  ///< below it what does not get smaller is rounding: a blocked stage hardly moves
/// change from which on steps are mixed; friction that blocks its stage runs away to where nothing moves, and has to be
/// let
constexpr double kNear = 0.3;
constexpr int kLines = 512;  ///< whatever the lines of the case: what moves does not depend on where one looks
constexpr double kSmallestVelocity = 1e-9;  ///< m/s; keeps the equivalent damping finite when nothing moves

/// Mean squares that the linearisation needs. The contact force is that which compresses the contact without its factor
/// as much.
struct MeanSquares {
    std::array<double, 4> primary_velocity{}, contact_force{};
    std::array<double, 2> secondary_velocity{};
};

/// What stays the same while the laws are iterated: rail and excitation of every group of lines.
struct UnchangedGroup {
    RailGroup rail;
    std::vector<WheelVector> irregularity;  ///< per source
    int count = 0;                          ///< lanes that are lines
    double step_hz = 0.0;
};

/// The lines that the rms values come from.
struct Lines {
    int count;
    double step_hz;
};

Lines lines_of(const FrequencyParameters& grid) {
    return {kLines, (grid.to_hz - grid.from_hz) / (kLines - 1)};
}

std::vector<UnchangedGroup> unchanged_groups(const CaseParameters& parameters, const std::vector<Source>& sources,
                                             const CoupledModel& model, const std::vector<RailGroup>* rails) {
    const auto [lines, step] = lines_of(parameters.frequency);
    std::vector<UnchangedGroup> groups;
    CoupledWorkspace workspace(model);
    for (int first = 0; first < lines; first += lanes::width) {
        LineGroup group{.step_hz = step};
        for (int lane = 0; lane < lanes::width; ++lane)
            group.omega[lane] = kTwoPi * (parameters.frequency.from_hz + std::min(first + lane, lines - 1) * step);
        UnchangedGroup own{.rail = rails ? (*rails)[groups.size()] : rail_group(group.omega, workspace),
                           .irregularity = {},
                           .count = std::min(lanes::width, lines - first),
                           .step_hz = step};
        for (const Source& source : sources) own.irregularity.push_back(source.amplitude(group));
        groups.push_back(std::move(own));
    }
    return groups;
}

MeanSquares mean_squares(const std::vector<UnchangedGroup>& groups, const CoupledModel& model) {
    MeanSquares sums;
    CoupledWorkspace workspace(model);
    for (const UnchangedGroup& group : groups) {
        const lanes::Real omega = group.rail.omega;
        const GroupSolution& solution = solve_group(model, group.rail, workspace);
        const lanes::Real softening = 1.0 / lanes::norm(model.contact_factor.at(omega));
        for (const WheelVector& irregularity : group.irregularity) {
            const WheelVector force = contact_forces(solution, irregularity);
            const auto add = [&](const std::array<lanes::Complex, 4>& receptance, double& sum) {
                lanes::Complex elongation;
                for (std::size_t j = 0; j < 4; ++j) elongation += receptance[j] * force[j];
                const lanes::Real square = lanes::norm(elongation) * omega * omega * group.step_hz;
                for (int lane = 0; lane < group.count; ++lane) sum += square[lane];
            };
            for (std::size_t e = 0; e < 4; ++e) {
                add(solution.car.primary[e], sums.primary_velocity[e]);
                const lanes::Real square = lanes::norm(force[e]) * softening * group.step_hz;
                for (int lane = 0; lane < group.count; ++lane) sums.contact_force[e] += square[lane];
            }
            for (std::size_t e = 0; e < 2; ++e) add(solution.car.secondary[e], sums.secondary_velocity[e]);
        }
    }
    return sums;
}

/// The equivalent elements that are looked for. All are positive, and ask for powers of each other: their logarithms
/// are iterated.
std::vector<double*> elements_of(const CaseParameters& parameters, CoupledModel& model) {
    std::vector<double*> result;
    const auto add = [&](auto& values) {
        for (double& value : values) result.push_back(&value);
    };
    if (parameters.vehicle.primary.friction_force_n > 0.0) add(model.car.friction.primary);
    if (parameters.vehicle.secondary.friction_force_n > 0.0) add(model.car.friction.secondary);
    if (parameters.contact.nonlinearity_factor > 0.0) add(model.contact_compliance);
    return result;
}

double friction_damping(double force, double velocity) {
    return force * std::sqrt(2.0 / std::numbers::pi) / std::max(velocity, kSmallestVelocity);
}

/// What the elements, in the order of elements_of(), ought to be when the response has these mean squares.
std::vector<double> targets_of(const CaseParameters& parameters, const MeanSquares& squares, const CoupledModel& model,
                               Linearisation& result) {
    std::vector<double> targets;
    const double constant = contact_constant(parameters.contact, parameters.vehicle.wheel_radius_m),
                 load = wheel_load_n(parameters);
    for (std::size_t e = 0; e < 4; ++e) {
        result.primary_velocity_m_per_s[e] = std::sqrt(squares.primary_velocity[e]);
        if (const double force = parameters.vehicle.primary.friction_force_n; force > 0.0)
            targets.push_back(friction_damping(force, result.primary_velocity_m_per_s[e]));
    }
    for (std::size_t e = 0; e < 2; ++e) {
        result.secondary_velocity_m_per_s[e] = std::sqrt(squares.secondary_velocity[e]);
        if (const double force = parameters.vehicle.secondary.friction_force_n; force > 0.0)
            targets.push_back(friction_damping(force, result.secondary_velocity_m_per_s[e]));
    }
    for (std::size_t e = 0; e < 4; ++e) {
        result.contact_compression_m[e] = std::sqrt(squares.contact_force[e]) * model.contact_compliance[e];
        if (const double share = parameters.contact.nonlinearity_factor; share > 0.0) {
            const MeanContact contact = mean_contact(constant, load, result.contact_compression_m[e]);
            result.loss_of_contact_probability[e] = contact.open_probability;
            const double linear = contact_stiffness(constant, load);
            targets.push_back(1.0 / std::max(0.05 * linear, linear + share * (contact.stiffness_n_per_m - linear)));
        }
    }
    return targets;
}

}  // namespace

bool is_nonlinear(const CaseParameters& parameters) {
    return parameters.vehicle.primary.friction_force_n > 0.0 || parameters.vehicle.secondary.friction_force_n > 0.0 ||
           parameters.contact.nonlinearity_factor > 0.0;
}

MeanContact mean_contact(double constant, double wheel_load, double deviation) {
    const double at_rest = constant * std::cbrt(wheel_load * wheel_load);  // δ0 = G·P0^{2/3}
    const double linear = contact_stiffness(constant, wheel_load);
    if (deviation <= 0.0) return {linear, 0.0};
    const double scale = std::pow(constant, -1.5);
    const auto force = [&](double mean) {
        return gaussian_mean([&](double xi) { return scale * std::pow(std::max(0.0, mean + deviation * xi), 1.5); });
    };
    const auto slope = [&](double mean) {
        return gaussian_mean([&](double xi) { return 1.5 * scale * std::sqrt(std::max(0.0, mean + deviation * xi)); });
    };
    // The quadrature's own value at rest is taken out, so that σ → 0 gives K_h to rounding.
    double mean = at_rest;
    for (int i = 0; i < 50; ++i) {
        const double step = (force(mean) - wheel_load) / slope(mean);
        mean -= step;
        if (std::abs(step) < 1e-12 * at_rest) break;
    }
    return {slope(mean), 0.5 * std::erfc(mean / deviation / std::numbers::sqrt2)};
}

VelocitySpectra velocity_spectra(const CaseParameters& parameters, const std::vector<Source>& sources,
                                 const CoupledModel& model, vehicle::Law law, const std::vector<RailGroup>& rails) {
    const std::vector<UnchangedGroup> groups = unchanged_groups(parameters, sources, model, &rails);
    const std::size_t n = law == vehicle::Law::primary ? 4 : 2;
    VelocitySpectra result{.from_hz = parameters.frequency.from_hz,
                           .step_hz = groups.front().step_hz,
                           .elements = n,
                           .lines = 0,
                           .values = {}};
    for (const UnchangedGroup& group : groups) result.lines += static_cast<std::size_t>(group.count);
    result.values.assign(result.lines * n * n, 0.0);
    CoupledWorkspace workspace(model);
    std::size_t first = 0;
    for (const UnchangedGroup& group : groups) {
        const GroupSolution& solution = solve_group(model, group.rail, workspace);
        for (const WheelVector& irregularity : group.irregularity) {
            const WheelVector force = contact_forces(solution, irregularity);
            std::array<lanes::Complex, 4> elongation{};
            for (std::size_t e = 0; e < n; ++e)
                for (std::size_t j = 0; j < 4; ++j)
                    elongation[e] +=
                        (law == vehicle::Law::primary ? solution.car.primary[e][j] : solution.car.secondary[e][j]) *
                        force[j];
            for (int lane = 0; lane < group.count; ++lane)
                for (std::size_t i = 0; i < n; ++i)
                    for (std::size_t j = 0; j < n; ++j)
                        result.values[((first + static_cast<std::size_t>(lane)) * n + i) * n + j] +=
                            group.rail.omega[lane] * group.rail.omega[lane] * elongation[i][lane] *
                            std::conj(elongation[j][lane]);
        }
        first += static_cast<std::size_t>(group.count);
    }
    return result;
}

std::vector<RailGroup> linearisation_rails(const CaseParameters& parameters, const CoupledModel& model,
                                           const RollingTable& rolling) {
    constexpr int kEvery = 4;
    const auto [count, step] = lines_of(parameters.frequency);
    if (!rolling.at.empty())
        return rolling_rails(rolling, model, parameters.frequency.from_hz, step, static_cast<std::size_t>(count),
                             kEvery);
    return rail_groups(model, parameters.frequency.from_hz, step, static_cast<std::size_t>(count), kEvery, 1);
}

Linearisation linearise(const CaseParameters& parameters, const std::vector<Source>& sources, CoupledModel& model,
                        const std::vector<RailGroup>* rails) {
    Linearisation result;
    if (!is_nonlinear(parameters)) return result;
    const std::vector<double*> elements = elements_of(parameters, model);
    const std::vector<UnchangedGroup> groups = unchanged_groups(parameters, sources, model, rails);
    track::AndersonMixing mixing;
    Eigen::VectorXd x(elements.size()), asked(elements.size());
    for (result.iterations = 1; result.iterations <= kMostIterations; ++result.iterations) {
        const std::vector<double> targets = targets_of(parameters, mean_squares(groups, model), model, result);
        const bool begun =
            std::all_of(elements.begin(), elements.end(), [](const double* value) { return *value > 0.0; });
        for (long e = 0; e < x.size(); ++e) {
            const auto i = static_cast<std::size_t>(e);
            x(e) = std::log(begun ? *elements[i] : targets[i]);
            asked(e) = begun ? std::log(targets[i]) - x(e) : 0.0;
        }
        const double before = result.change;
        result.change = begun ? asked.lpNorm<Eigen::Infinity>() : 1.0;
        const bool settled =
            result.change < kSettled || (result.change < kRounding && result.change > 0.5 * before && before > 0.0);
        if (begun)
            x += settled || result.change > kNear
                     ? asked
                     : Eigen::VectorXd(mixing.step(x, asked).cwiseMax(-kNear).cwiseMin(kNear));
        for (long e = 0; e < x.size(); ++e) *elements[static_cast<std::size_t>(e)] = std::exp(x(e));
        if (settled) break;
    }
    return result;
}

}  // namespace railpem::pem
