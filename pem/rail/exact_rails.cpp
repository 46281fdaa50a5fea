#include "pem/rail/exact_rails.hpp"

#include <optional>

#include "track/rail/scattered_rail.hpp"

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
            : law(rail.pads, rail.support, omega, rail.modifiers), waves(track::bloch_waves(rail, omega, law)) {}
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

}  // namespace

std::unique_ptr<RailModel> exact_rails(std::vector<track::ExactRail> rails) {
    return std::make_unique<ExactModel>(std::move(rails));
}

}  // namespace railpem::pem
