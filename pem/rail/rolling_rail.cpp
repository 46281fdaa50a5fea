#include "pem/rail/rolling_rail.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "pem/rail/case_equilibrium.hpp"
#include "pem/rail/exact_rails.hpp"
#include "track/rail/mean_seats.hpp"
#include "track/rail/rolling_receptance.hpp"
#include "track/statics/moving_equilibrium.hpp"

namespace railpem::pem {

namespace {

/// What stands in the place of the equal seats less those, in the mean over the same positions of the wheels.
class DifferenceEvaluator : public RailEvaluator {
  public:
    DifferenceEvaluator(const RailModel& own, const RailModel& equal)
        : own_(own.evaluator()), equal_(equal.evaluator()) {}

    const track::RailReceptance& at(lanes::Real omega) override {
        result_ = own_->at(omega);
        const track::RailReceptance& without = equal_->at(omega);
        for (std::size_t pair = 0; pair < result_.between.size(); ++pair)
            result_.between[pair] -= without.between[pair];
        for (std::size_t wheel = 0; wheel < result_.trackbed.size(); ++wheel)
            result_.trackbed[wheel] -= without.trackbed[wheel];
        return result_;
    }
    // without the equal seats: they swing by whole bays only
    const track::RailReceptance& at_place(int place, lanes::Real omega) override {
        return own_->at_place(place, omega);
    }

  private:
    std::unique_ptr<RailEvaluator> own_, equal_;
    track::RailReceptance result_;
};

class SeatsThatDiffer : public RailModel {
  public:
    SeatsThatDiffer(std::unique_ptr<RailModel> own, std::unique_ptr<RailModel> equal)
        : own_(std::move(own)), equal_(std::move(equal)) {}
    std::unique_ptr<RailEvaluator> evaluator() const override {
        return std::make_unique<DifferenceEvaluator>(*own_, *equal_);
    }
    int places() const override { return own_->places(); }

  private:
    std::unique_ptr<RailModel> own_, equal_;
};

struct Rolling {
    EqualSeats equal;
    std::vector<double> wheels_m;
    double speed_m_per_s;
    std::unique_ptr<RailModel> others;  ///< SeatsThatDiffer, or none
    std::optional<track::PadHistory> constant_loads;
    std::optional<SeatPlaces> places;
};

class RollingEvaluator : public RailEvaluator {
  public:
    explicit RollingEvaluator(const Rolling& rolling) : rolling_(rolling) {
        const std::size_t wheels = rolling.wheels_m.size();
        result_.between.resize(wheels * wheels);
        result_.trackbed.resize(wheels);
        if (rolling.others) others_ = rolling.others->evaluator();
    }

    const track::RailReceptance& at(lanes::Real omega) override {
        double previous = 0.0;
        track::RollingReceptance receptance;
        for (int lane = 0; lane < lanes::width; ++lane) {
            const double frequency = omega[lane] / (2.0 * std::numbers::pi);
            if (frequency != previous)
                receptance = track::rolling_receptance(rolling_.equal.track, rolling_.equal.pad_stiffness_n_per_m,
                                                       rolling_.wheels_m, rolling_.speed_m_per_s, frequency, 0,
                                                       rolling_.equal.modifiers);
            previous = frequency;  // the last group repeats its last line
            for (std::size_t pair = 0; pair < result_.between.size(); ++pair)
                result_.between[pair].set(lane, receptance.values[pair]);
        }
        const lanes::Complex trackbed = track::rolling_trackbed(
            rolling_.equal.track, rolling_.equal.pad_stiffness_n_per_m, omega, rolling_.equal.modifiers);
        for (lanes::Complex& own : result_.trackbed) own = trackbed;
        if (others_) {
            const track::RailReceptance& beside = others_->at(omega);
            for (std::size_t pair = 0; pair < result_.between.size(); ++pair)
                result_.between[pair] += beside.between[pair];
            for (std::size_t wheel = 0; wheel < result_.trackbed.size(); ++wheel)
                result_.trackbed[wheel] += beside.trackbed[wheel];
        }
        return result_;
    }

  private:
    const Rolling& rolling_;
    std::unique_ptr<RailEvaluator> others_;
    track::RailReceptance result_;
};

class RollingModel : public RailModel {
  public:
    explicit RollingModel(Rolling rolling) : rolling_(std::move(rolling)) {}
    std::unique_ptr<RailEvaluator> evaluator() const override { return std::make_unique<RollingEvaluator>(rolling_); }
    const EqualSeats* equal_seats() const override { return &rolling_.equal; }
    const RailModel* beside_equal_seats() const override { return rolling_.others.get(); }
    const SeatPlaces* seat_places() const override { return rolling_.places ? &*rolling_.places : nullptr; }
    const track::PadHistory* constant_loads() const override {
        return rolling_.constant_loads ? &*rolling_.constant_loads : nullptr;
    }

  private:
    Rolling rolling_;
};

/// Mean K0 of the sound supports within a bay of a wheel: that of the equal seats on which the motion is.
double stiffness_under_points(const track::ExactRail& rail) {
    double sum = 0.0, count = 0.0;
    for (const track::RailNode& point : rail.nodes) {
        if (point.point < 0) continue;
        for (const track::RailNode& node : rail.nodes) {
            if (!node.supported || node.pad_scale != 1.0 ||
                std::abs(node.position_m - point.position_m) > 1.01 * rail.spacing_m)
                continue;
            sum += node.pad_stiffness_n_per_m;
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : rail.uniform_pad_stiffness_n_per_m;
}

/// Where to begin with n positions per bay, in bays. A rail that shears has a kink over every seat, and the mean of n
/// places misses that of all by ½h²·B₂(θ) times the jump of the slope, h = spacing/n and θ·h the distance of a seat to
/// the next place of the wheel (Euler and Maclaurin; B₂(θ) = θ² − θ + 1/6). It was 0.4 % of the response at 114 Hz with
/// three. The offset at which that is least over the wheels: nothing where all of them stand alike to the seats.
double offset_between_kinks(const std::vector<double>& wheels_m, double spacing_m, int n) {
    constexpr int kTried = 256;
    double best = 0.0, least = 1e300;
    for (int i = 0; i < kTried; ++i) {
        double sum = 0.0;
        for (const double wheel : wheels_m) {
            const double place = static_cast<double>(i) / kTried + n * (wheel - wheels_m.front()) / spacing_m,
                         theta = place - std::floor(place);
            sum += std::pow(theta * theta - theta + 1.0 / 6.0, 2);
        }
        if (sum < least) least = sum, best = static_cast<double>(i) / kTried / n;
    }
    return best;
}

/// How many places of the wheels in a bay take the first two harmonics out of the receptance, and where they begin.
struct Places {
    int per_bay;
    double first_bay;

    Places(const track::TrackParameters& track, const std::vector<double>& wheels_m)
        : per_bay(track.rail.beam == track::Beam::timoshenko ? 4 : 3),
          first_bay(per_bay == 4 ? offset_between_kinks(wheels_m, track.spacing_m, per_bay) : 0.0) {}
};

/// The case on the pads that stand for all where some fail at random.
CaseParameters on_mean_pads(const CaseParameters& parameters) {
    CaseParameters mean = parameters;
    const lanes::FactorCurve factor =
        track::mean_of_failed(parameters.track, dynamic_equilibrium(parameters).unloaded_dynamic_stiffness_n_per_m,
                              parameters.modifiers.track);
    if (factor.empty()) return mean;
    const lanes::FactorCurve& known = parameters.modifiers.track.pads;
    lanes::FactorCurve& pads = mean.modifiers.track.pads;
    pads = factor;
    for (std::size_t i = 0; i < pads.value.size(); ++i)
        pads.value[i] *= known.at(2.0 * std::numbers::pi * pads.frequency_hz[i]);
    for (track::FailedFasteners& failed : mean.track.failed_fasteners) failed.fraction = 0.0;
    return mean;
}

int failure_period(const track::TrackParameters& track) {
    int period = 1;
    for (const track::FailedFasteners& failed : track.failed_fasteners) period = std::max(period, failed.every);
    return period;
}

/// The rails of all places, every bay of a period of failed fasteners.
std::vector<track::ExactRail> rails_at(const Places& places, const CaseParameters& parameters,
                                       const std::vector<double>& wheels_m, const track::PadHistory* rolling) {
    CaseParameters moved = parameters;
    const int period = failure_period(moved.track),
              first_seat = moved.track.failed_fasteners.empty() ? 0 : moved.track.failed_fasteners.front().first_seat;
    track::PassingChange change;
    if (rolling) change = track::passing_change(moved.track, wheels_m, wheel_load_n(parameters), *rolling);
    std::vector<track::ExactRail> rails;
    track::StaticEquilibrium previous;
    for (int k = 0; k < places.per_bay * period; ++k) {
        const double bays = places.first_bay + static_cast<double>(k) / places.per_bay;
        moved.track.wheel_offset_m = (bays - std::floor(bays)) * parameters.track.spacing_m;
        for (track::FailedFasteners& failed : moved.track.failed_fasteners)
            failed.first_seat = first_seat - static_cast<int>(bays);
        previous = rolling ? track::moving_equilibrium(moved.track, wheels_m, wheel_load_n(parameters),
                                                       case_pads(moved, wheels_m), change, &previous)
                           : dynamic_equilibrium(moved);
        rails.push_back(track::exact_rail(moved.track, wheels_m, previous, moved.modifiers.track));
    }
    return rails;
}

std::unique_ptr<RailModel> on_equal_seats(const Places& places, const CaseParameters& parameters,
                                          const std::vector<double>& wheels_m, double pad_stiffness) {
    const track::TrackParameters& track = parameters.track;
    std::vector<track::ExactRail> rails;
    for (int k = 0; k < places.per_bay; ++k) {
        std::vector<double> moved = wheels_m;
        for (double& wheel : moved)
            wheel += (places.first_bay + static_cast<double>(k) / places.per_bay) * track.spacing_m;
        rails.push_back(track::uniform_rail(track, moved, pad_stiffness, parameters.modifiers.track));
    }
    return exact_rails(std::move(rails));
}

}  // namespace

std::unique_ptr<RailModel> rolling_rail(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                        double speed_m_per_s) {
    const CaseParameters mean = on_mean_pads(parameters);
    const Places places(mean.track, wheels_m);
    if (mean.track.pads.preload_strength == 0.0 && failure_period(mean.track) == 1) {
        const double sound = dynamic_equilibrium(mean).unloaded_dynamic_stiffness_n_per_m;
        return std::make_unique<RollingModel>(
            Rolling{{mean.track, mean.modifiers.track, sound}, wheels_m, speed_m_per_s, {}, {}, {}});
    }
    std::optional<track::PadHistory> rolling;
    if (mean.track.pads.preload_strength > 0.0)
        rolling = track::pad_history(mean.track, wheels_m, wheel_load_n(parameters), speed_m_per_s, false, {}, nullptr,
                                     mean.modifiers.track);
    std::vector<track::ExactRail> rails = rails_at(places, mean, wheels_m, rolling ? &*rolling : nullptr);
    if (!parameters.track.failed_fasteners.empty()) rolling.reset();
    const double pad = stiffness_under_points(rails.front());
    auto others =
        std::make_unique<SeatsThatDiffer>(exact_rails(std::move(rails)), on_equal_seats(places, mean, wheels_m, pad));
    std::optional<SeatPlaces> seats;
    if (const int period = failure_period(mean.track); period > 1) seats = SeatPlaces{period, places.first_bay};
    return std::make_unique<RollingModel>(Rolling{{mean.track, mean.modifiers.track, pad},
                                                  wheels_m,
                                                  speed_m_per_s,
                                                  std::move(others),
                                                  std::move(rolling),
                                                  seats});
}

std::unique_ptr<RailModel> rolling_rail(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                        double speed_m_per_s, std::unique_ptr<RailModel> standing) {
    track::StaticEquilibrium equal = dynamic_equilibrium(parameters);
    const double pad =
        stiffness_under_points(track::exact_rail(parameters.track, wheels_m, equal, parameters.modifiers.track));
    equal.unloaded_dynamic_stiffness_n_per_m = pad;
    equal.dynamic_stiffness_n_per_m.assign(equal.position_m.size(), pad);
    auto others = std::make_unique<SeatsThatDiffer>(
        std::move(standing),
        exact_rails({track::exact_rail(parameters.track, wheels_m, equal, parameters.modifiers.track)}));
    return std::make_unique<RollingModel>(Rolling{
        {parameters.track, parameters.modifiers.track, pad}, wheels_m, speed_m_per_s, std::move(others), {}, {}});
}

}  // namespace railpem::pem
