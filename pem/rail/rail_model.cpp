#include "pem/rail/rail_model.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "pem/rail/rolling_rail.hpp"
#include "track/rail/exact_rail.hpp"
#include "track/rail/modal_rail.hpp"
#include "track/rail/scattered_rail.hpp"
#include "track/statics/equilibria_abreast.hpp"
#include "track/statics/seat_stiffness.hpp"

namespace railpem::pem {

namespace {

/// One position of the wheels: the rail, and where its seats differ the same as what they scatter, which is cheaper.
struct PreparedRail {
    track::ExactRail exact;
    std::optional<track::ScatteredRail> scattered;
};

/// Receptances of one position of the wheels after the other, and their mean. The uniform track is the same for all of
/// them.
class ExactEvaluator : public RailEvaluator {
  public:
    explicit ExactEvaluator(const std::vector<PreparedRail>& rails) : rails_(rails), elimination_(rails.size()) {
        const std::size_t points = static_cast<std::size_t>(rails.front().exact.points);
        for (track::RailReceptance* result : {&scattered_, &mean_}) {
            result->between.resize(points * points);
            result->trackbed.resize(points);
        }
    }

    const track::RailReceptance& at(lanes::Real omega) override {
        waves_.reset();
        if (rails_.size() == 1) return at(0, omega);
        mean_ = at(0, omega);
        for (std::size_t i = 1; i < rails_.size(); ++i) {
            const track::RailReceptance& other = at(i, omega);
            for (std::size_t k = 0; k < mean_.between.size(); ++k) mean_.between[k] += other.between[k];
            for (std::size_t k = 0; k < mean_.trackbed.size(); ++k) mean_.trackbed[k] += other.trackbed[k];
        }
        const double share = 1.0 / static_cast<double>(rails_.size());
        for (lanes::Complex& value : mean_.between) value = value * share;
        for (lanes::Complex& value : mean_.trackbed) value = value * share;
        return mean_;
    }

    const track::RailReceptance& at_place(int place, lanes::Real omega) override {
        if (place == 0) waves_.reset();
        return at(static_cast<std::size_t>(place), omega);
    }

  private:
    struct UniformTrack {
        track::SupportLaw law;
        track::BlochWaves waves;
        UniformTrack(const track::ExactRail& rail, lanes::Real omega)
            : law(rail.pads, rail.support, omega), waves(track::bloch_waves(rail, omega, law)) {}
    };

    const track::RailReceptance& at(std::size_t i, lanes::Real omega) {
        const PreparedRail& rail = rails_[i];
        if (rail.scattered) {
            if (!waves_) waves_.emplace(rail.exact, omega);
            if (track::scattered_receptance(*rail.scattered, waves_->waves, waves_->law,
                                            rail.exact.uniform_pad_stiffness_n_per_m, seats_, scattered_))
                return scattered_;
        }
        if (!elimination_[i]) elimination_[i].emplace(rail.exact);
        return track::rail_receptance(rail.exact, omega, *elimination_[i]);
    }

    const std::vector<PreparedRail>& rails_;
    std::optional<UniformTrack> waves_;  ///< of the present ω
    std::vector<std::optional<track::ExactRailWorkspace>> elimination_;
    track::ScatteredWorkspace seats_;
    track::RailReceptance scattered_, mean_;
};

class ExactModel : public RailModel {
  public:
    explicit ExactModel(std::vector<track::ExactRail> rails) {
        for (track::ExactRail& rail : rails) {
            std::optional<track::ScatteredRail> scattered = track::scattered_rail(rail);
            rails_.push_back({std::move(rail), std::move(scattered)});
        }
    }
    std::unique_ptr<RailEvaluator> evaluator() const override { return std::make_unique<ExactEvaluator>(rails_); }
    int places() const override { return static_cast<int>(rails_.size()); }

  private:
    std::vector<PreparedRail> rails_;
};

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

std::vector<double> case_pads(const CaseParameters& parameters, const std::vector<double>& wheels) {
    return track::pad_positions(parameters.track, wheels,
                                parameters.solver.rail == RailSolution::modal ? parameters.solver.pads : 0);
}

track::StaticEquilibrium case_equilibrium(const CaseParameters& parameters) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    return track::static_equilibrium(parameters.track, wheels, wheel_load_n(parameters), case_pads(parameters, wheels));
}

track::StaticEquilibrium dynamic_equilibrium(const CaseParameters& parameters, const track::StaticEquilibrium* start) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const std::vector<double> pads = case_pads(parameters, wheels);
    if (parameters.track.pads.preload_strength == 0.0) return track::load_independent_pads(parameters.track, pads);
    return track::static_equilibrium(parameters.track, wheels, wheel_load_n(parameters), pads, start);
}

std::vector<track::StaticEquilibrium> dynamic_equilibria(const CaseParameters& parameters,
                                                         const std::vector<int>& first_seats,
                                                         const std::vector<track::StaticEquilibrium>& start) {
    const bool alike = parameters.track.failed_fasteners.empty() || parameters.track.pads.preload_strength == 0.0;
    if (alike)
        return std::vector(first_seats.size(),
                           dynamic_equilibrium(parameters, start.empty() ? nullptr : &start.front()));
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    return track::equilibria_abreast(parameters.track, wheels, wheel_load_n(parameters), case_pads(parameters, wheels),
                                     first_seats, start);
}

std::unique_ptr<RailModel> exact_rails(std::vector<track::ExactRail> rails) {
    return std::make_unique<ExactModel>(std::move(rails));
}

std::unique_ptr<RailModel> rail_model(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                      const track::StaticEquilibrium& equilibrium, double speed_m_per_s) {
    const bool exact = parameters.solver.rail == RailSolution::exact,
               rolls = parameters.solver.moving && speed_m_per_s > 0.0;
    if (exact && rolls) return rolling_rail(parameters, wheels_m, speed_m_per_s);
    std::unique_ptr<RailModel> standing;
    if (exact)
        standing = exact_rails({track::exact_rail(parameters.track, wheels_m, equilibrium)});
    else
        standing = std::make_unique<ModalModel>(parameters.track, wheels_m, parameters.solver.modes, equilibrium);
    return rolls ? rolling_rail(parameters, wheels_m, speed_m_per_s, std::move(standing)) : std::move(standing);
}

}  // namespace railpem::pem
