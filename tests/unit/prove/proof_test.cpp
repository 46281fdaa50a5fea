// A proof goes on where it was ended, in one piece or in shards.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/input_error.hpp"
#include "app/prove/proof.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/tables/simulated_recording_files.hpp"
#include "tests/unit/prove/proof_case.hpp"

namespace railpem::app {
namespace {

namespace fs = std::filesystem;

class Proof : public testing::Test {
  protected:
    Proof() : folder_(fs::temp_directory_path() / ("railpem_proof_" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
        settings_.trials = 6;
        settings_.draw.seed = 3;
    }
    ~Proof() override { fs::remove_all(folder_); }

    /// Runs with a diagnosis that always says the same; ends after `most` trials.
    std::vector<std::size_t> run(const ProofSettings& settings, std::size_t most = 1000) {
        const ProofFolder folder(folder_, settings_text(own_.file, settings));
        const std::vector<TrialTruth> truths = draw_trials(own_.file, own_.believed, settings);
        folder.seal(truths);
        std::vector<std::size_t> kept;
        const auto runner = [](const TrialTruth& truth, const fs::path&) {
            return TrialResult{.trial = truth.trial, .verdict = "consistent"};
        };
        run_trials(
            truths, settings, folder, runner,
            [&](std::size_t, std::size_t, const TrialResult& last) { kept.push_back(last.trial); },
            [&] { return kept.size() >= most; });
        return kept;
    }

    ProofCase own_;
    ProofSettings settings_;
    fs::path folder_;
};

TEST_F(Proof, GoesOnWhereItWasEnded) {
    EXPECT_EQ(run(settings_, 2), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(run(settings_), (std::vector<std::size_t>{2, 3, 4, 5}));
    EXPECT_TRUE(run(settings_).empty());
}

TEST_F(Proof, ShardsAddUpAndAProofCanBeLengthened) {
    settings_.shard = read_shard("2/3");
    EXPECT_EQ(run(settings_), (std::vector<std::size_t>{1, 4}));
    settings_.shard = {};
    settings_.trials = 8;
    EXPECT_EQ(run(settings_), (std::vector<std::size_t>{0, 2, 3, 5, 6, 7}));
}

TEST_F(Proof, TruthsLieThereBeforeTheFirstTrial) {
    EXPECT_TRUE(run(settings_, 0).empty());
    std::size_t truths = 0;
    for ([[maybe_unused]] const fs::directory_entry& entry : fs::directory_iterator(folder_ / "truth")) ++truths;
    EXPECT_EQ(truths, settings_.trials);
}

TEST_F(Proof, AnotherProofIsRefused) {
    run(settings_, 1);
    ProofSettings other = settings_;
    other.draw.seed = 4;
    EXPECT_THROW(run(other), InputError);
    other = settings_;
    other.options.diagnosis.thresholds.credible += 1.0;
    EXPECT_THROW(run(other), InputError);
}

TEST_F(Proof, ATruthThatWasTouchedIsRefused) {
    run(settings_, 1);
    std::ofstream(folder_ / "truth" / "0002.json", std::ios::app) << " ";
    EXPECT_THROW(run(settings_), InputError);
}

TEST_F(Proof, ATrialThatWasCutShortIsNotKept) {
    const ProofFolder folder(folder_, settings_text(own_.file, settings_));
    const std::vector<TrialTruth> truths = draw_trials(own_.file, own_.believed, settings_);
    bool asked = false;
    const auto runner = [&](const TrialTruth& truth, const fs::path&) {
        asked = truth.trial == 1;
        return TrialResult{.trial = truth.trial, .verdict = "consistent"};
    };
    run_trials(
        truths, settings_, folder, runner, [](std::size_t, std::size_t, const TrialResult&) {}, [&] { return asked; });
    EXPECT_TRUE(folder.finished(0).has_value());
    EXPECT_FALSE(folder.finished(1).has_value());
}

TEST(ReadShard, RefusesWhatIsNone) {
    for (const char* text : {"", "1", "0/2", "3/2", "a/b", "1/2/3", "-1/2"})
        EXPECT_THROW(read_shard(text), InputError) << text;
}

// In memory and through the files a diagnosis meets the same recording: seven digits apart.
TEST(MeasuredRecording, IsWhatItsFilesWouldBe) {
    const ProofCase own;
    TrialTruth truth = own.draw(3, 0);
    truth.seconds = 7.0;  // the case begins at 0.3 Hz
    truth.records.resize(1);
    const std::vector<simulate::Recording> records = simulate_trial(truth, 1);
    const recordings::Recording direct = measured_recording(records.front());
    const fs::path folder = fs::temp_directory_path() / ("railpem_measured_" + std::to_string(::getpid()));
    {
        OutputFolder output(folder);
        write_simulated_recording(output, records.front(), RecordingFormat::csv);
        output.commit();
    }
    const recordings::Recording read = load_recording(read_recording(folder.string()));
    fs::remove_all(folder);
    ASSERT_EQ(direct.series.channels.size(), read.series.channels.size());
    EXPECT_NEAR(direct.description.speed_m_per_s, read.description.speed_m_per_s, 1e-8);
    EXPECT_EQ(direct.series.sampling_rate_hz, read.series.sampling_rate_hz);
    for (std::size_t c = 0; c < direct.series.channels.size(); ++c) {
        const recordings::Channel &a = direct.series.channels[c], &b = read.series.channels[c];
        EXPECT_EQ(a.description.name, b.description.name);
        EXPECT_EQ(a.description.location, b.description.location);
        EXPECT_EQ(a.description.index, b.description.index);
        EXPECT_NEAR(a.description.position_m, b.description.position_m, 1e-5);
        ASSERT_EQ(a.samples.size(), b.samples.size());
        for (std::size_t i = 0; i < a.samples.size(); i += 97)
            EXPECT_NEAR(a.samples[i], b.samples[i], 1e-6 * std::abs(a.samples[i]) + 1e-12);
    }
}

}  // namespace
}  // namespace railpem::app
