#include "pem/rail_model.hpp"

#include <cmath>
#include <numbers>

#include "track/convected_rail.hpp"
#include "track/exact_rail.hpp"
#include "track/modal_rail.hpp"
#include "track/seat_stiffness.hpp"

namespace railpem::pem {

namespace {

class ExactEvaluator : public RailEvaluator {
  public:
    explicit ExactEvaluator(const track::ExactRail& rail) : rail_(rail), workspace_(rail) {}
    const track::RailReceptance& at(lanes::Real omega) override { return track::rail_receptance(rail_, omega, workspace_); }

  private:
    const track::ExactRail& rail_;
    track::ExactRailWorkspace workspace_;
};

/// Mean K0 of the supports within a bay of a wheel: what the smeared track of the convected change stands on.
double stiffness_under_points(const track::ExactRail& rail) {
    double sum = 0.0, count = 0.0;
    for (const track::RailNode& point : rail.nodes) {
        if (point.point < 0) continue;
        for (const track::RailNode& node : rail.nodes) {
            if (!node.supported || std::abs(node.position_m - point.position_m) > 1.01 * rail.spacing_m) continue;
            sum += node.pad_stiffness_n_per_m * node.pad_scale;
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : rail.uniform_pad_stiffness_n_per_m;
}

class ExactModel : public RailModel {
  public:
    explicit ExactModel(track::ExactRail rail) : rail_(std::move(rail)) {}
    std::unique_ptr<RailEvaluator> evaluator() const override { return std::make_unique<ExactEvaluator>(rail_); }

    std::vector<std::complex<double>> convected_change(double omega, double speed, const std::vector<double>& separations) const override {
        return track::convected_change(rail_, stiffness_under_points(rail_), omega, speed, separations);
    }

  private:
    track::ExactRail rail_;
};

/// The design's rail, line by line through a dense solve.
class ModalEvaluator : public RailEvaluator {
  public:
    ModalEvaluator(const track::ModalRail& rail, const track::TrackParameters& track, const track::StaticEquilibrium& equilibrium)
        : rail_(rail), track_(track), equilibrium_(equilibrium) {}

    const track::RailReceptance& at(lanes::Real omega) override {
        const std::size_t points = static_cast<std::size_t>(rail_.point_shape.rows());
        result_.between.resize(points * points);
        result_.trackbed.resize(points);
        double previous = 0.0;
        track::ModalReceptance modal;
        for (int lane = 0; lane < lanes::width; ++lane) {
            const double frequency = omega[lane] / (2.0 * std::numbers::pi);
            if (frequency != previous) modal = track::modal_receptance(rail_, frequency, track::seat_stiffness(track_, equilibrium_, frequency));
            previous = frequency;  // the last group repeats its last line
            for (std::size_t i = 0; i < points; ++i) {
                for (std::size_t j = 0; j < points; ++j)
                    result_.between[i * points + j].set(lane, modal.at_points(static_cast<long>(i), static_cast<long>(j)));
                result_.trackbed[i].set(lane, modal.trackbed(static_cast<long>(i)));
            }
        }
        return result_;
    }

  private:
    const track::ModalRail& rail_;
    const track::TrackParameters& track_;
    const track::StaticEquilibrium& equilibrium_;
    track::RailReceptance result_;
};

class ModalModel : public RailModel {
  public:
    ModalModel(const track::TrackParameters& track, const std::vector<double>& points, int modes, track::StaticEquilibrium equilibrium)
        : track_(track),
          equilibrium_(std::move(equilibrium)),
          rail_(track::modal_rail(track_, equilibrium_.position_m, points, modes)),
          smeared_(track::exact_rail(track_, points, equilibrium_)) {}
    std::unique_ptr<RailEvaluator> evaluator() const override { return std::make_unique<ModalEvaluator>(rail_, track_, equilibrium_); }
    std::vector<std::complex<double>> convected_change(double omega, double speed, const std::vector<double>& separations) const override {
        return track::convected_change(smeared_, stiffness_under_points(smeared_), omega, speed, separations);
    }

  private:
    track::TrackParameters track_;
    track::StaticEquilibrium equilibrium_;
    track::ModalRail rail_;
    track::ExactRail smeared_;  ///< only for the convected change
};

}  // namespace

track::StaticEquilibrium case_equilibrium(const CaseParameters& parameters) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const int count = parameters.solver.rail == RailSolution::modal ? parameters.solver.pads : 0;
    return track::static_equilibrium(parameters.track, wheels, wheel_load_n(parameters), track::pad_positions(parameters.track, wheels, count));
}

std::unique_ptr<RailModel> rail_model(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                      const track::StaticEquilibrium& equilibrium) {
    if (parameters.solver.rail == RailSolution::modal)
        return std::make_unique<ModalModel>(parameters.track, wheels_m, parameters.solver.modes, equilibrium);
    return std::make_unique<ExactModel>(track::exact_rail(parameters.track, wheels_m, equilibrium));
}

}  // namespace railpem::pem
