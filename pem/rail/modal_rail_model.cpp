#include "pem/rail/modal_rail_model.hpp"

#include <numbers>

#include "track/rail/modal_rail.hpp"
#include "track/statics/seat_stiffness.hpp"

namespace railpem::pem {

namespace {

/// The design's rail, line by line through a dense solve.
class ModalEvaluator : public RailEvaluator {
  public:
    ModalEvaluator(const track::ModalRail& rail, const track::TrackParameters& track,
                   const track::TrackModifiers& modifiers, const track::StaticEquilibrium& equilibrium)
        : rail_(rail), track_(track), modifiers_(modifiers), equilibrium_(equilibrium) {}

    const track::RailReceptance& at(lanes::Real omega) override {
        const std::size_t points = static_cast<std::size_t>(rail_.point_shape.rows());
        result_.between.resize(points * points);
        result_.trackbed.resize(points);
        double previous = 0.0;
        track::ModalReceptance modal;
        for (int lane = 0; lane < lanes::width; ++lane) {
            const double frequency = omega[lane] / (2.0 * std::numbers::pi);
            if (frequency != previous)
                modal = track::modal_receptance(rail_, frequency,
                                                track::seat_stiffness(track_, equilibrium_, frequency, modifiers_));
            previous = frequency;  // the last group repeats its last line
            for (std::size_t i = 0; i < points; ++i) {
                for (std::size_t j = 0; j < points; ++j)
                    result_.between[i * points + j].set(lane,
                                                        modal.at_points(static_cast<long>(i), static_cast<long>(j)));
                result_.trackbed[i].set(lane, modal.trackbed(static_cast<long>(i)));
            }
        }
        return result_;
    }

  private:
    const track::ModalRail& rail_;
    const track::TrackParameters& track_;
    const track::TrackModifiers& modifiers_;
    const track::StaticEquilibrium& equilibrium_;
    track::RailReceptance result_;
};

class ModalModel : public RailModel {
  public:
    ModalModel(const CaseParameters& parameters, const std::vector<double>& wheels_m,
               const track::StaticEquilibrium& equilibrium)
        : track_(parameters.track),
          modifiers_(parameters.modifiers.track),
          equilibrium_(equilibrium),
          rail_(track::modal_rail(track_, equilibrium_.position_m, wheels_m, parameters.solver.modes, modifiers_)) {}
    std::unique_ptr<RailEvaluator> evaluator() const override {
        return std::make_unique<ModalEvaluator>(rail_, track_, modifiers_, equilibrium_);
    }

  private:
    track::TrackParameters track_;
    track::TrackModifiers modifiers_;
    track::StaticEquilibrium equilibrium_;
    track::ModalRail rail_;
};

}  // namespace

std::unique_ptr<RailModel> modal_rail_model(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                            const track::StaticEquilibrium& equilibrium) {
    return std::make_unique<ModalModel>(parameters, wheels_m, equilibrium);
}

}  // namespace railpem::pem
