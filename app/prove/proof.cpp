#include "app/prove/proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/fingerprint.hpp"
#include "app/input_error.hpp"
#include "app/output_folder.hpp"
#include "app/program_version.hpp"
#include "app/prove/effect_draws.hpp"

namespace railpem::app {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::string file_name(std::size_t trial) {
    return fmt::format("{:04}.json", trial);
}

std::optional<std::string> text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void write_file(const fs::path& folder, const std::string& name, const std::string& text) {
    OutputFolder output(folder);
    output.write(name, text);
    output.commit();
}

Json ranges_json() {
    Json list = Json::array();
    for (const std::vector<EffectDraw>* draws : {&physics_draws(), &sensor_draws(), &outside_draws()})
        for (const EffectDraw& draw : *draws) {
            Json parameters = Json::object();
            for (const DrawnParameter& p : draw.parameters)
                parameters[p.name] = {p.low,    p.high, static_cast<int>(p.spacing), static_cast<int>(p.mirror),
                                      p.offset, p.power};
            list.push_back({{"effect", draw.id}, {"parameters", parameters}});
        }
    return list;
}

Json draw_json(const DrawSettings& draw) {
    Json json{{"seed", draw.seed},
              {"mix", draw.mix.shares},
              {"seconds", draw.seconds},
              {"most_records", draw.most_records},
              {"speeds_m_per_s", {draw.least_speed_m_per_s, draw.most_speed_m_per_s}},
              {"speed_ratio", draw.speed_ratio},
              {"speed_error", draw.speed_error},
              {"payload_share", draw.payload_share},
              {"payload_kg", {draw.least_payload_kg, draw.most_payload_kg}},
              {"level_db", draw.level_db},
              {"noise_rms_m_per_s2", draw.noise_rms_m_per_s2},
              {"ranges", fingerprint_text(ranges_json().dump())}};
    if (!draw.world.is_ideal()) json["world"] = world_json(draw.world);
    return json;
}

Json diagnosis_json_of(const TrialOptions& options) {
    const diagnosis::VerdictThresholds& thresholds = options.diagnosis.thresholds;
    const diagnosis::NamingOptions& naming = options.diagnosis.naming;
    return {{"least_gain", thresholds.least_gain},
            {"belief_gain", thresholds.belief_gain},
            {"credible", thresholds.credible},
            {"residual", thresholds.residual},
            {"number_tolerances", thresholds.number_tolerances},
            {"level_db", thresholds.level_db},
            {"anonymous", thresholds.anonymous},
            {"most_effects", naming.most_effects},
            {"refits", naming.refits},
            {"later_refits", naming.later_refits},
            {"naming_residual", naming.residual},
            {"naming_least_promise", naming.least_promise},
            {"naming_least_gain", naming.least_gain},
            {"window_s", options.observation.window_s},
            {"low_hz", options.observation.low_hz},
            {"high_hz", options.observation.high_hz},
            {"held_out_share", options.observation.held_out_share}};
}

/// What was hidden, in short, for whoever reads the file of a trial.
std::string label_json(const TrialTruth& truth) {
    Json effects = Json::array();
    for (const simulate::Hidden& hidden : truth.hidden) effects.push_back(Json::parse(simulate::hidden_json(hidden)));
    return Json{{"kind", kind_name(truth.kind)}, {"effects", effects}}.dump();
}

}  // namespace

Shard read_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    std::size_t index = 0, count = 0;
    const auto read = [](const std::string& part, std::size_t& value) {
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        return error == std::errc() && end == part.data() + part.size();
    };
    if (slash == std::string::npos || !read(text.substr(0, slash), index) || !read(text.substr(slash + 1), count) ||
        index < 1 || index > count)
        throw InputError(
            fmt::format("--shard: cannot be '{}'\nallowed: i/n with whole numbers 1 <= i <= n, as in 2/4", text));
    return {index - 1, count};
}

std::string settings_text(const CaseFile& file, const ProofSettings& settings) {
    return Json{{"program", "railpem " + program_version()},
                {"case", file.name},
                {"case_fingerprint", fingerprint_text(write_case(file.without_effects, file.effects))},
                {"draw", draw_json(settings.draw)},
                {"diagnosis", diagnosis_json_of(settings.options)}}
               .dump(2) +
           "\n";
}

ProofFolder::ProofFolder(std::filesystem::path folder, const std::string& settings) : folder_(std::move(folder)) {
    const std::optional<std::string> found = text_of(folder_ / "proof.json");
    if (!found)
        write_file(folder_, "proof.json", settings);
    else if (*found != settings)
        throw InputError(
            fmt::format("{}: was made with other settings (seed, case, thresholds, ranges or version of the program)\n"
                        "allowed: the settings that proof.json states, or another --out",
                        (folder_ / "proof.json").string()));
}

void ProofFolder::seal(const std::vector<TrialTruth>& truths) const {
    OutputFolder output(folder_ / "truth");
    for (const TrialTruth& truth : truths) {
        const std::string name = file_name(truth.trial), text = trial_truth_text(truth);
        const std::optional<std::string> found = text_of(output.path() / name);
        if (found && *found != text)
            throw InputError(
                fmt::format("{}: is not what this program draws from this seed\nallowed: another --out, or the program "
                            "that drew it",
                            (output.path() / name).string()));
        if (!found) output.write(name, text);
    }
    output.commit();
}

std::optional<TrialResult> ProofFolder::finished(std::size_t trial) const {
    const fs::path file = folder_ / "trials" / file_name(trial);
    const std::optional<std::string> text = text_of(file);
    if (!text) return std::nullopt;
    return read_trial_result(file.string(), *text);
}

void ProofFolder::keep(const TrialTruth& truth, const TrialResult& result) const {
    write_file(folder_ / "trials", file_name(truth.trial), trial_result_text(result, label_json(truth)));
}

std::filesystem::path ProofFolder::recordings_of(std::size_t trial) const {
    return folder_ / "trials" / fmt::format("{:04}", trial);
}

std::vector<TrialTruth> draw_trials(const CaseFile& file, const diagnosis::BelievedCase& believed,
                                    const ProofSettings& settings) {
    std::vector<TrialTruth> truths;
    for (std::size_t trial = 0; trial < settings.trials; ++trial)
        truths.push_back(draw_trial(file, believed, settings.draw, trial));
    return truths;
}

void run_trials(const std::vector<TrialTruth>& truths, const ProofSettings& settings, const ProofFolder& folder,
                const TrialRunner& run, const ProofProgress& progress, const std::function<bool()>& interrupted,
                std::function<std::optional<std::size_t>()> next) {
    if (!next)
        next = [place = std::size_t{0}, &truths]() mutable {
            return place < truths.size() ? std::optional(place++) : std::nullopt;
        };
    const auto open = [&](const TrialTruth& truth) {
        return settings.shard.holds(truth.trial) && !folder.finished(truth.trial);
    };
    const std::size_t all = static_cast<std::size_t>(std::count_if(truths.begin(), truths.end(), open));
    std::size_t done = 0;
    for (std::optional<std::size_t> i; !interrupted() && (i = next());) {
        const TrialTruth& truth = truths[*i];
        if (!open(truth)) continue;
        const TrialResult result = run(truth, settings.keep ? folder.recordings_of(truth.trial) : fs::path());
        if (interrupted()) return;
        folder.keep(truth, result);
        progress(++done, all, result);
    }
}

}  // namespace railpem::app
