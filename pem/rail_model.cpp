#include "pem/rail_model.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "track/equilibria_abreast.hpp"
#include "track/exact_rail.hpp"
#include "track/modal_rail.hpp"
#include "track/moving_equilibrium.hpp"
#include "track/scattered_rail.hpp"
#include "track/seat_stiffness.hpp"

namespace railpem::pem {

namespace {

/// One position of the wheels: the rail, and where its seats differ the same as what they scatter, which is cheaper.
struct PreparedRail {
    track::ExactRail exact;
    std::optional<track::ScatteredRail> scattered;
};

/// Receptances of one position of the wheels after the other, and their mean. The uniform track is the same for all of them.
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
            if (track::scattered_receptance(*rail.scattered, waves_->waves, waves_->law, rail.exact.uniform_pad_stiffness_n_per_m, seats_, scattered_))
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
    explicit ExactModel(std::vector<track::ExactRail> rails) : smeared_pad_(stiffness_under_points(rails.front())) {
        for (track::ExactRail& rail : rails) {
            std::optional<track::ScatteredRail> scattered = track::scattered_rail(rail);
            rails_.push_back({std::move(rail), std::move(scattered)});
        }
    }
    std::unique_ptr<RailEvaluator> evaluator() const override { return std::make_unique<ExactEvaluator>(rails_); }

    void convected_change(double omega, double speed, const std::vector<double>& distances, track::ConvectedChange* change) const override {
        track::convected_change(rails_.front().exact, smeared_pad_, omega, speed, distances, change);
    }

  private:
    std::vector<PreparedRail> rails_;
    double smeared_pad_;
};

std::vector<double> case_pads(const CaseParameters& parameters, const std::vector<double>& wheels) {
    return track::pad_positions(parameters.track, wheels, parameters.solver.rail == RailSolution::modal ? parameters.solver.pads : 0);
}

/// Where to begin with n positions per bay, in bays. A rail that shears has a kink over every seat, and the mean of n places misses that of all by ½h²·B₂(θ) times the jump of the slope, h = spacing/n
/// and θ·h the distance of a seat to the next place of the wheel (Euler and Maclaurin; B₂(θ) = θ² − θ + 1/6). It was 0.4 % of the response at 114 Hz with three. The offset at which that is least
/// over the wheels: nothing where all of them stand alike to the seats.
double offset_between_kinks(const std::vector<double>& wheels_m, double spacing_m, int n) {
    constexpr int kTried = 256;
    double best = 0.0, least = 1e300;
    for (int i = 0; i < kTried; ++i) {
        double sum = 0.0;
        for (const double wheel : wheels_m) {
            const double place = static_cast<double>(i) / kTried + n * (wheel - wheels_m.front()) / spacing_m, theta = place - std::floor(place);
            sum += std::pow(theta * theta - theta + 1.0 / 6.0, 2);
        }
        if (sum < least) least = sum, best = static_cast<double>(i) / kTried / n;
    }
    return best;
}

/// Rails for wheels that roll over the track: at rest one, as the case has it. In motion the mean over positions that take
/// the first two harmonics of a bay out of the receptance (three per bay, four on a rail that shears, and every bay of a period of failed fasteners);
/// random failures enter by their mean. Pads that preload stiffens are those under rolling wheels (track/moving_equilibrium.hpp).
std::vector<track::ExactRail> positions(const CaseParameters& parameters, const std::vector<double>& wheels_m, const track::StaticEquilibrium& equilibrium,
                                        double speed_m_per_s) {
    if (!parameters.solver.moving) return {track::exact_rail(parameters.track, wheels_m, equilibrium)};
    const bool shears = parameters.track.rail.beam == track::Beam::timoshenko;
    const int per_bay = shears ? 4 : 3;
    const double first_bay = shears ? offset_between_kinks(wheels_m, parameters.track.spacing_m, per_bay) : 0.0;
    CaseParameters moved = parameters;
    int period = 1;
    for (track::FailedFasteners& failed : moved.track.failed_fasteners) {
        if (failed.every > 0) period = failed.every;
        const double mean = 1.0 - failed.fraction * (1.0 - failed.remaining_stiffness_fraction);
        moved.track.pads.dynamic_to_static_ratio *= mean;
        moved.track.pads.damping_n_s_per_m *= mean;
        failed.fraction = 0.0;
    }
    const int first_seat = moved.track.failed_fasteners.empty() ? 0 : moved.track.failed_fasteners.front().first_seat;
    const bool load_matters = moved.track.pads.preload_strength > 0.0;
    track::PassingChange change;
    if (load_matters) change = track::passing_change(moved.track, wheels_m, wheel_load_n(parameters), speed_m_per_s);
    std::vector<track::ExactRail> rails;
    track::StaticEquilibrium previous;
    for (int k = 0; k < per_bay * period; ++k) {
        const double bays = first_bay + static_cast<double>(k) / per_bay;
        moved.track.wheel_offset_m = (bays - std::floor(bays)) * parameters.track.spacing_m;
        for (track::FailedFasteners& failed : moved.track.failed_fasteners) failed.first_seat = first_seat - static_cast<int>(bays);
        previous = load_matters ? track::moving_equilibrium(moved.track, wheels_m, wheel_load_n(parameters), case_pads(moved, wheels_m), change, &previous)
                                : dynamic_equilibrium(moved);
        rails.push_back(track::exact_rail(moved.track, wheels_m, previous));
    }
    return rails;
}

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
    void convected_change(double omega, double speed, const std::vector<double>& distances, track::ConvectedChange* change) const override {
        track::convected_change(smeared_, stiffness_under_points(smeared_), omega, speed, distances, change);
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
    return track::static_equilibrium(parameters.track, wheels, wheel_load_n(parameters), case_pads(parameters, wheels));
}

track::StaticEquilibrium dynamic_equilibrium(const CaseParameters& parameters, const track::StaticEquilibrium* start) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const std::vector<double> pads = case_pads(parameters, wheels);
    if (parameters.track.pads.preload_strength == 0.0) return track::load_independent_pads(parameters.track, pads);
    return track::static_equilibrium(parameters.track, wheels, wheel_load_n(parameters), pads, start);
}

std::vector<track::StaticEquilibrium> dynamic_equilibria(const CaseParameters& parameters, const std::vector<int>& first_seats,
                                                         const std::vector<track::StaticEquilibrium>& start) {
    const bool alike = parameters.track.failed_fasteners.empty() || parameters.track.pads.preload_strength == 0.0;
    if (alike) return std::vector(first_seats.size(), dynamic_equilibrium(parameters, start.empty() ? nullptr : &start.front()));
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    return track::equilibria_abreast(parameters.track, wheels, wheel_load_n(parameters), case_pads(parameters, wheels), first_seats, start);
}

std::unique_ptr<RailModel> rail_model(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                      const track::StaticEquilibrium& equilibrium, double speed_m_per_s) {
    if (parameters.solver.rail == RailSolution::modal)
        return std::make_unique<ModalModel>(parameters.track, wheels_m, parameters.solver.modes, equilibrium);
    return std::make_unique<ExactModel>(positions(parameters, wheels_m, equilibrium, speed_m_per_s));
}

}  // namespace railpem::pem
