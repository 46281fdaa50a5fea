#include "pem/rail_model.hpp"

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

class ExactModel : public RailModel {
  public:
    explicit ExactModel(track::ExactRail rail) : rail_(std::move(rail)) {}
    std::unique_ptr<RailEvaluator> evaluator() const override { return std::make_unique<ExactEvaluator>(rail_); }

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
