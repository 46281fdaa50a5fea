#include "app/prove/trial_draw.hpp"

#include <algorithm>
#include <cassert>

#include "app/input_error.hpp"
#include "app/prove/draw_stream.hpp"
#include "app/prove/hidden_draw.hpp"
#include "app/schema/hide_option.hpp"

namespace railpem::app {

namespace {

enum Purpose : std::uint64_t { for_kinds = 1, for_orders = 2, for_trials = 1000 };

// multiples of it modulo 1 fill an interval evenly, however many they are
constexpr double kGolden = 0.6180339887498949;
constexpr int kMostAttempts = 200;  // until effects are drawn that the case can have

TrialKind kind_of(const DrawSettings& settings, std::size_t trial) {
    const double begin = simulate::uniform_at(simulate::derived_seed(settings.seed, for_kinds), 0);
    double rest = std::fmod(begin + static_cast<double>(trial) * kGolden, 1.0);
    for (std::size_t kind = 0; kind < settings.mix.shares.size(); ++kind) {
        rest -= settings.mix.shares[kind];
        if (rest < 0.0) return static_cast<TrialKind>(kind);
    }
    return TrialKind::nothing;
}

/// Trials of the same kind before this one.
std::size_t rank_of(const DrawSettings& settings, std::size_t trial, TrialKind kind) {
    std::size_t rank = 0;
    for (std::size_t before = 0; before < trial; ++before) rank += kind_of(settings, before) == kind;
    return rank;
}

/// The identifiers in the order in which they take turns.
std::vector<std::string> in_turn(std::vector<std::string> ids, const DrawSettings& settings, TrialKind kind) {
    DrawStream stream(simulate::derived_seed(settings.seed, for_orders + 10 * static_cast<std::uint64_t>(kind)));
    for (std::size_t i = ids.size(); i > 1; --i) std::swap(ids[i - 1], ids[stream.index(i)]);
    return ids;
}

std::vector<TrialRecord> draw_records(const DrawSettings& settings, DrawStream& stream) {
    std::vector<TrialRecord> records(1 + stream.index(static_cast<std::size_t>(settings.most_records)));
    const auto apart = [&](double a, double b) { return std::max(a, b) / std::min(a, b) >= settings.speed_ratio; };
    for (std::size_t i = 0; i < records.size(); ++i) {
        TrialRecord& record = records[i];
        do record.speed_m_per_s = stream.uniform(settings.least_speed_m_per_s, settings.most_speed_m_per_s);
        while (!std::all_of(records.begin(), records.begin() + static_cast<long>(i), [&](const TrialRecord& other) {
            return apart(other.speed_m_per_s, record.speed_m_per_s);
        }));
        record.stated_speed_m_per_s = record.speed_m_per_s * (1.0 + settings.speed_error * stream.uniform(-1.0, 1.0));
        record.seed = stream.bits() >> 1;  // as --seed takes it
    }
    if (records.size() > 1 && stream.chance(settings.payload_share))
        records[stream.index(records.size())].payload_kg =
            stream.uniform(settings.least_payload_kg, settings.most_payload_kg);
    return records;
}

std::vector<simulate::Hidden> draw_hidden(const CaseFile& file, const diagnosis::BelievedCase& believed,
                                          const DrawSettings& settings, const TrialTruth& truth, DrawStream& stream) {
    if (truth.kind == TrialKind::nothing) return {};
    const std::vector<std::string> ids = in_turn(drawable_effects(file, truth.kind), settings, truth.kind);
    assert(!ids.empty());
    const std::string& first = ids[rank_of(settings, truth.trial, truth.kind) % ids.size()];
    std::vector<simulate::Hidden> hidden{draw_effect(first, file, believed, truth.records, stream)};
    if (truth.kind == TrialKind::pair) {
        std::string second;
        do second = ids[stream.index(ids.size())];
        while (second == first);
        hidden.push_back(draw_effect(second, file, believed, truth.records, stream));
    }
    return hidden;
}

/// The true world: the believed one with every number off within its tolerance.
void draw_numbers(const diagnosis::BelievedCase& believed, const DrawSettings& settings, DrawStream& stream,
                  TrialTruth& truth) {
    for (const diagnosis::BelievedNumber& number : believed.uncertain) {
        const double off = 1.0 + number.tolerance * stream.uniform(-1.0, 1.0);
        believed.access.set(truth.parameters, number.key, number.value * off);
        truth.numbers.push_back({.key = number.key, .believed = number.value});
    }
    truth.level_db = settings.level_db * stream.uniform(-1.0, 1.0);
    truth.parameters.irregularity.level_db += truth.level_db;
}

}  // namespace

std::vector<std::string> drawable_effects(const CaseFile& file, TrialKind kind) {
    std::vector<std::string> ids;
    const auto add = [&](const std::vector<EffectDraw>& draws) {
        for (const EffectDraw& draw : draws) {
            const diagnosis::Effect* effect = diagnosis::find_effect(draw.id);
            if (effect && effect->obstacle && effect->obstacle(file.parameters)) continue;
            if (std::find(ids.begin(), ids.end(), draw.id) == ids.end()) ids.push_back(draw.id);
        }
    };
    if (kind == TrialKind::single || kind == TrialKind::pair) add(physics_draws());
    if (kind == TrialKind::sensor) add(sensor_draws());
    if (kind == TrialKind::parameter_error) add({parameter_error_draw()});
    if (kind == TrialKind::outside) add(outside_draws());
    return ids;
}

TrialTruth draw_trial(const CaseFile& file, const diagnosis::BelievedCase& believed, const DrawSettings& settings,
                      std::size_t trial) {
    const std::uint64_t seed = simulate::derived_seed(settings.seed, for_trials + trial);
    DrawStream stream(seed);
    TrialTruth nuisance{.trial = trial,
                        .kind = kind_of(settings, trial),
                        .noise_rms_m_per_s2 = settings.world.is_ideal() ? settings.noise_rms_m_per_s2 : 0.0,
                        .seconds = settings.seconds,
                        .parameters = file.parameters,
                        .world = settings.world};
    nuisance.parameters.contact.constant_m_per_n23 = believed.numbers.contact.constant_m_per_n23;
    nuisance.records = draw_records(settings, stream);
    draw_numbers(believed, settings, stream, nuisance);
    for (int attempt = 0;; ++attempt) {
        TrialTruth truth = nuisance;
        truth.hidden = draw_hidden(file, believed, settings, truth, stream);
        try {
            const CaseWithHidden with = hide_in_case(truth.parameters, truth.hidden);
            truth.parameters = with.parameters;
            truth.only_here = with.only_here;
        } catch (const InputError&) {
            if (attempt >= kMostAttempts) throw;
            continue;
        }
        for (TrueNumber& number : truth.numbers) number.truth = believed.access.get(truth.parameters, number.key);
        return truth;
    }
}

}  // namespace railpem::app
