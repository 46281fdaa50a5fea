#include "diagnosis/expectation/friction_spectra.hpp"

#include <numbers>

#include "pem/coupling/friction_distortion.hpp"
#include "pem/coupling/linearise.hpp"

namespace railpem::diagnosis {

namespace {

/// A stage with friction.
struct FrictionStage {
    vehicle::Law law;
    double force_n;
    std::vector<double> damping;  ///< equivalent, of every element
};

std::vector<FrictionStage> stages_of(const pem::CaseParameters& parameters, const pem::CoupledModel& model) {
    const double primary = parameters.vehicle.primary.friction_force_n,
                 secondary = parameters.vehicle.secondary.friction_force_n;
    std::vector<FrictionStage> stages;
    if (primary > 0.0)
        stages.push_back(
            {vehicle::Law::primary, primary, {model.car.friction.primary.begin(), model.car.friction.primary.end()}});
    if (secondary > 0.0)
        stages.push_back({vehicle::Law::secondary,
                          secondary,
                          {model.car.friction.secondary.begin(), model.car.friction.secondary.end()}});
    return stages;
}

const pem::RealisedFriction& of_stage(const StageFriction& both, vehicle::Law law) {
    return law == vehicle::Law::primary ? both.primary : both.secondary;
}

void add_stage(const pem::CaseParameters& parameters, const SolvedLines& solved, const LevelLines& level,
               const FrictionStage& stage, const std::vector<ObservedChannel>& channels, double bin_hz,
               ExpectedSpectra& expected) {
    const pem::VelocitySpectra velocity =
        pem::velocity_spectra(parameters, level.sources, solved.model, stage.law, level.rails);
    std::vector<std::complex<double>> power = pem::friction_distortion(velocity, stage.force_n);
    for (std::complex<double>& own : power) own *= level.power;
    const long elements = static_cast<long>(velocity.elements);
    const LineTable psd{power.data(), elements, elements, velocity.from_hz, velocity.step_hz, velocity.lines};
    const lanes::FactorCurve rest = level.realised ? of_stage(*level.realised, stage.law).power : lanes::FactorCurve{};
    add_inner_forces(
        parameters, solved, stage.law,
        [&](double f) { return RowMatrix(rest.at(2.0 * std::numbers::pi * f).real() * psd.at(f)); }, channels, bin_hz,
        expected);
}

}  // namespace

bool has_friction(const pem::CaseParameters& parameters) {
    return parameters.vehicle.primary.friction_force_n > 0.0 || parameters.vehicle.secondary.friction_force_n > 0.0;
}

void add_friction(const pem::CaseParameters& parameters, const SolvedLines& solved, const LevelLines& level,
                  const std::vector<ObservedChannel>& channels, double bin_hz, ExpectedSpectra& expected) {
    for (const FrictionStage& stage : stages_of(parameters, solved.model))
        add_stage(parameters, solved, level, stage, channels, bin_hz, expected);
}

StageFriction realised_friction(const pem::CaseParameters& parameters, const pem::CoupledModel& model,
                                const LevelLines& level) {
    StageFriction both;
    for (const FrictionStage& stage : stages_of(parameters, model)) {
        const pem::VelocitySpectra velocity =
            pem::velocity_spectra(parameters, level.sources, model, stage.law, level.rails);
        const pem::ElementTransfers transfers =
            pem::element_transfers(model, stage.law, velocity.from_hz, velocity.step_hz, velocity.lines, level.rails);
        (stage.law == vehicle::Law::primary ? both.primary : both.secondary) =
            pem::realised_friction(velocity, transfers, stage.damping, stage.force_n);
    }
    return both;
}

void follow_damping(const pem::CaseParameters& parameters, const SolvedLines& solved, const StageFriction& realised,
                    const std::vector<ObservedChannel>& channels, pem::WheelTransfers& transfers) {
    for (const FrictionStage& stage : stages_of(parameters, solved.model)) {
        const pem::InnerTransfers inner = pem::inner_transfers(solved.model, stage.law, solved.from_hz, solved.step_hz,
                                                               solved.lines, transfers.responses, solved.rails);
        const pem::ElementTransfers elements =
            pem::element_transfers(solved.model, stage.law, solved.from_hz, solved.step_hz, solved.lines, solved.rails);
        const long n = static_cast<long>(elements.elements), size = static_cast<long>(channels.size());
        const Eigen::VectorXcd damping =
            Eigen::Map<const Eigen::VectorXd>(stage.damping.data(), n).cast<std::complex<double>>();
        for (std::size_t line = 0; line < solved.lines; ++line) {
            const double frequency = solved.from_hz + static_cast<double>(line) * solved.step_hz;
            const std::complex<double> beyond =
                of_stage(realised, stage.law).damping.at(2.0 * std::numbers::pi * frequency);
            const Eigen::Map<const RowMatrix> velocity(elements.by_wheel.data() + line * elements.elements * 4, n, 4),
                felt(inner.at(line), size, n);
            Eigen::Map<RowMatrix> transfer(transfers.values.data() + line * channels.size() * 4, size, 4);
            const RowMatrix added = felt * (beyond * damping.asDiagonal()) * velocity;
            for (long c = 0; c < size; ++c)
                transfer.row(c) -=
                    channel_factor(parameters, channels[static_cast<std::size_t>(c)], frequency) * added.row(c);
        }
    }
}

}  // namespace railpem::diagnosis
