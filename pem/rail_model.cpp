#include "pem/rail_model.hpp"

#include <cmath>

#include "track/convected_rail.hpp"
#include "track/exact_rail.hpp"
#include "track/modal_rail.hpp"

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

}  // namespace

track::StaticEquilibrium case_equilibrium(const CaseParameters& parameters) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const int count = parameters.solver.rail == RailSolution::modal ? parameters.solver.pads : 0;
    return track::static_equilibrium(parameters.track, wheels, wheel_load_n(parameters), track::pad_positions(parameters.track, wheels, count));
}

std::unique_ptr<RailModel> rail_model(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                      const track::StaticEquilibrium& equilibrium) {
    return std::make_unique<ExactModel>(track::exact_rail(parameters.track, wheels_m, equilibrium));
}

}  // namespace railpem::pem
