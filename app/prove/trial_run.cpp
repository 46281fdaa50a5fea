#include "app/prove/trial_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <future>
#include <iterator>
#include <thread>

#include "app/tables/simulated_recording_files.hpp"
#include "diagnosis/observations/observe.hpp"
#include "simulate/march/simulate.hpp"

namespace railpem::app {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

simulate::Recording simulate_record(const TrialTruth& truth, const TrialRecord& record) {
    pem::CaseParameters parameters = truth.parameters;
    parameters.vehicle.payload_kg = record.payload_kg;
    simulate::Options options{.seconds = truth.seconds,
                              .speed_m_per_s = record.speed_m_per_s,
                              .seed = record.seed,
                              .noise_rms_m_per_s2 = truth.noise_rms_m_per_s2};
    options.only_here = truth.only_here;
    options.world = truth.world.parameters;
    simulate::Recording recording = simulate::simulate(parameters, options);
    // The stated speed is off by the same share where the speed varies and its mean is not what was asked for.
    recording.speed_m_per_s = truth.world.is_ideal()
                                  ? record.stated_speed_m_per_s
                                  : recording.speed_m_per_s * record.stated_speed_m_per_s / record.speed_m_per_s;
    return recording;
}

recordings::Location location_of(const std::string& name) {
    return name == "wheel"   ? recordings::Location::wheel
           : name == "bogie" ? recordings::Location::bogie
                             : recordings::Location::body;
}

void keep_recordings(const std::vector<simulate::Recording>& records, const std::filesystem::path& folder) {
    for (std::size_t i = 0; i < records.size(); ++i) {
        OutputFolder own(folder / fmt::format("record_{}", i + 1));
        write_simulated_recording(own, records[i], RecordingFormat::csv);
        own.commit();
    }
}

}  // namespace

std::vector<simulate::Recording> simulate_trial(const TrialTruth& truth, int threads) {
    const int most = threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<simulate::Recording> records(truth.records.size());
    for (std::size_t begin = 0; begin < records.size(); begin += static_cast<std::size_t>(most)) {
        const std::size_t end = std::min(records.size(), begin + static_cast<std::size_t>(most));
        std::vector<std::future<simulate::Recording>> running;
        for (std::size_t i = begin; i < end; ++i)
            running.push_back(
                std::async(std::launch::async, [&truth, i] { return simulate_record(truth, truth.records[i]); }));
        for (std::size_t i = begin; i < end; ++i) records[i] = running[i - begin].get();
    }
    return records;
}

recordings::Recording measured_recording(const simulate::Recording& simulated) {
    recordings::Recording recording;
    recording.description = {.data = "recording.csv",
                             .sampling_rate_hz = simulated.sampling_rate_hz,
                             .speed_m_per_s = simulated.speed_m_per_s,
                             .speed_standard_error_m_per_s = simulated.speed_standard_error_m_per_s,
                             .payload_kg = simulated.payload_kg};
    recording.series.sampling_rate_hz = simulated.sampling_rate_hz;
    for (const simulate::Channel& channel : simulated.channels) {
        const recordings::ChannelDescription description{.name = channel.name,
                                                         .column = channel.name,
                                                         .unit = "m/s^2",
                                                         .location = location_of(channel.location),
                                                         .index = channel.index,
                                                         .position_m = channel.position_m};
        recording.description.channels.push_back(description);
        recording.series.channels.push_back({description, channel.acceleration_m_per_s2});
    }
    return recording;
}

diagnosis::Diagnosis diagnose_recordings(const diagnosis::BelievedCase& believed,
                                         const std::vector<recordings::Recording>& recordings,
                                         const TrialOptions& options) {
    std::vector<diagnosis::Observation> observations;
    for (std::size_t i = 0; i < recordings.size(); ++i)
        std::ranges::move(
            diagnosis::observe(recordings[i], fmt::format("record_{}", i + 1), believed.numbers, options.observation),
            std::back_inserter(observations));
    return diagnosis::diagnose(believed, observations, options.diagnosis);
}

TrialResult run_trial(const diagnosis::BelievedCase& believed, const TrialTruth& truth, const TrialOptions& options,
                      const std::filesystem::path& keep) {
    const Clock::time_point begin = Clock::now();
    std::vector<recordings::Recording> measured;
    try {
        const std::vector<simulate::Recording> records = simulate_trial(truth, options.diagnosis.threads);
        if (!keep.empty()) keep_recordings(records, keep);
        for (const simulate::Recording& record : records) measured.push_back(measured_recording(record));
    } catch (const OutputError&) {
        throw;
    } catch (const std::exception& error) {
        return {.trial = truth.trial, .failure = fmt::format("simulation: {}", error.what())};
    }
    const double simulated = seconds_since(begin);
    TrialResult result{.trial = truth.trial};
    const Clock::time_point diagnosed = Clock::now();
    try {
        result = trial_result(truth.trial, diagnose_recordings(believed, measured, options));
    } catch (const std::exception& error) {
        result.failure = fmt::format("diagnosis: {}", error.what());
    }
    result.seconds_simulated = simulated;
    result.seconds_diagnosed = seconds_since(diagnosed);
    return result;
}

}  // namespace railpem::app
