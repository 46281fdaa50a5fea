#include "pem/rail/modal_rail_model.hpp"

#include <numbers>
#include <utility>

#include "track/rail/modal_rail.hpp"
#include "track/statics/seat_stiffness.hpp"

namespace railpem::pem {

namespace {

/// The design's rail, line by line through a dense solve.
class ModalEvaluator : public RailEvaluator {
  public:
    ModalEvaluator(const track::ModalRail& rail, const track::TrackParameters& track,
                   const track::StaticEquilibrium& equilibrium)
        : rail_(rail), track_(track), equilibrium_(equilibrium) {}

    const track::RailReceptance& at(lanes::Real omega) override {
        const std::size_t points = static_cast<std::size_t>(rail_.point_shape.rows());
        result_.between.resize(points * points);
        result_.trackbed.resize(points);
        double previous = 0.0;
        track::ModalReceptance modal;
        for (int lane = 0; lane < lanes::width; ++lane) {
            const double frequency = omega[lane] / (2.0 * std::numbers::pi);
            if (frequency != previous)
                modal =
                    track::modal_receptance(rail_, frequency, track::seat_stiffness(track_, equilibrium_, frequency));
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
    const track::StaticEquilibrium& equilibrium_;
    track::RailReceptance result_;
};

class ModalModel : public RailModel {
  public:
    ModalModel(const track::TrackParameters& track, const std::vector<double>& points, int modes,
               track::StaticEquilibrium equilibrium)
        : track_(track),
          equilibrium_(std::move(equilibrium)),
          rail_(track::modal_rail(track_, equilibrium_.position_m, points, modes)) {}
    std::unique_ptr<RailEvaluator> evaluator() const override {
        return std::make_unique<ModalEvaluator>(rail_, track_, equilibrium_);
    }

  private:
    track::TrackParameters track_;
    track::StaticEquilibrium equilibrium_;
    track::ModalRail rail_;
};

}  // namespace

std::unique_ptr<RailModel> modal_rail_model(const track::TrackParameters& track, const std::vector<double>& points_m,
                                            int modes, const track::StaticEquilibrium& equilibrium) {
    return std::make_unique<ModalModel>(track, points_m, modes, equilibrium);
}

}  // namespace railpem::pem
