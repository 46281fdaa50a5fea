#include "app/report/diagnosis_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/report/chart_data.hpp"
#include "app/report/words.hpp"
#include "diagnosis_fixtures.hpp"

namespace railpem::app {
namespace {

using diagnosis::Diagnosis;

const std::string kCommand = "railpem diagnose case.toml run_60 run_80 --out 'a <b>'";

/// The page without Chart.js, scripts and style: what is said and drawn.
std::string content(const Diagnosis& diagnosis) {
    const std::string page = diagnosis_report(diagnosis, {.command = kCommand});
    const std::size_t begin = page.find("<main>"), end = page.find("</main>");
    return page.substr(begin, end - begin);
}

nlohmann::json data(const Diagnosis& diagnosis) {
    const std::string page = diagnosis_report(diagnosis, {.command = kCommand});
    const std::size_t begin = page.find("id=\"report\">") + 12, end = page.find("</script>", begin);
    return nlohmann::json::parse(page.substr(begin, end - begin));
}

TEST(DiagnosisReport, NeedsNothingBesideIt) {
    const std::string page = diagnosis_report(testing::explained(), {.command = kCommand});
    for (const char* link : {"src=", "href=", "@import", "url("})
        EXPECT_EQ(content(testing::explained()).find(link), std::string::npos) << link;
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);
    for (const char* part : {"Chart.js v", "prefers-color-scheme: dark", "@media print", "max-width: 820px"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST(DiagnosisReport, AnswersInTheOrderOfTheQuestions) {
    const std::string page = content(testing::explained());
    std::size_t at = 0;
    for (const char* heading : {"<h1>Left out: the rail pads grow stiffer", "<h2>Where it is",
                                "<h2>Channel × frequency", "<h2>Recorded against simulated", "<h2>What was left out",
                                "<h2>How much it explains", "<h2>What calibration would have hidden", "<h2>Rivals",
                                "<h2>What remains", "<h2>The dynamic stiffness", "<h2>The data", "<h2>To repeat it"}) {
        const std::size_t next = page.find(heading, at);
        ASSERT_NE(next, std::string::npos) << heading;
        at = next;
    }
}

TEST(DiagnosisReport, SaysWhereRetunedKeepsItsBeliefs) {
    Diagnosis diagnosis = testing::explained();
    EXPECT_EQ(content(diagnosis).find("within two tolerances, as everywhere"), std::string::npos);
    diagnosis.freely_retuned = diagnosis::FreelyRetuned{.fitted = {0.4231, -318.5}, .held_out = {0.9312, 11.54}};
    const std::string page = content(diagnosis);
    for (const char* words :
         {"removes <b>97 %</b> of the likelihood deficit and brings the misfit from 3.4 dB to 0.42 dB",
          "where it keeps it within two tolerances, as everywhere else on this page, it gets to 0.14 dB",
          "it reaches 0.42 dB and log-likelihood -318", "it reaches 0.93 dB and log-likelihood 11.5"})
        EXPECT_NE(page.find(words), std::string::npos) << words;
}

// Of a wrong number the primary suspension had 97 % and, where retuning has left nothing, "-63 nats".
TEST(DiagnosisReport, APlaceWithoutEvidenceOfItsOwnHasNoNats) {
    Diagnosis diagnosis = testing::explained();
    diagnosis.places = {{diagnosis::Element::primary, 0.97, -63.0}, {diagnosis::Element::pad, 0.01, 4.5}};
    const std::string page = content(diagnosis);
    EXPECT_NE(page.find(">97 %</span>"), std::string::npos);
    EXPECT_EQ(page.find("-63"), std::string::npos);
    EXPECT_NE(page.find(" %, 4.5 nats</span>"), std::string::npos);
}

TEST(DiagnosisReport, EveryClaimHasItsNumber) {
    const std::string page = content(testing::explained());
    for (const char* number : {"0.151",
                               "0.134 to 0.168",
                               "95 %",
                               "433 nats",
                               "0.19 dB",
                               "0.19</i>",
                               "0.05</i> dB",
                               "413",
                               "98.3",
                               "-12.6",
                               "97 %",
                               "+46.0 %",
                               "+2.5 tolerances",
                               "+3.7 tolerances",
                               "outside its tolerance",
                               "14.2 nats behind; on data unseen 88.7 nats over retuning",
                               "58–92 Hz",
                               "+3.1 dB",
                               "1e-6",
                               "&lt; 1e-12",
                               "16.67 m/s",
                               "21.4 of 4 s",
                               "41.7 s",
                               "loss_factor 0.231",
                               "Fenander 1997"})
        EXPECT_NE(page.find(number), std::string::npos) << number;
}

TEST(DiagnosisReport, TextFromFilesIsHarmless) {
    const std::string page = diagnosis_report(testing::explained(), {.command = kCommand});
    EXPECT_EQ(page.find("bogie_<b>"), std::string::npos);
    EXPECT_NE(page.find("bogie_&lt;b&gt;&amp;&quot;2&quot;"), std::string::npos);
    EXPECT_NE(page.find("--out &#39;a &lt;b&gt;&#39;"), std::string::npos);
    Diagnosis diagnosis = testing::explained();
    diagnosis.channels[0].channel = "</script><script>alert(1)</script>";
    EXPECT_EQ(diagnosis_report(diagnosis, {.command = ""}).find("<script>alert"), std::string::npos);
    EXPECT_EQ(data(diagnosis)["channels"][0]["name"], "</script><script>alert(1)</script>, run_60");
}

TEST(DiagnosisReport, NeverSaysNotANumber) {
    for (const Diagnosis& diagnosis : testing::every_verdict()) {
        const std::string page = content(diagnosis) + data(diagnosis).dump();
        EXPECT_FALSE(std::regex_search(page, std::regex("[^a-z](nan|inf)[^a-z]"))) << verdict_name(diagnosis.verdict);
    }
}

TEST(DiagnosisReport, OfNothingAtAllIsStillAPage) {
    const Diagnosis empty;
    EXPECT_NE(content(empty).find("Something is missing that no known effect explains."), std::string::npos);
    EXPECT_TRUE(data(empty)["channels"].empty());
}

TEST(DiagnosisReport, EachVerdictHasItsSentence) {
    EXPECT_NE(content(testing::ambiguous())
                  .find("2 explanations stand: pad-hysteresis or pad-preload-stiffening + support-compliance."),
              std::string::npos);
    EXPECT_NE(content(testing::consistent()).find("<h1>Nothing significant is missing"), std::string::npos);
    EXPECT_NE(content(testing::unexplained()).find("missing at the support that no known effect"), std::string::npos);
    EXPECT_NE(content(testing::unexplained()).find("interrupted: what is known so far"), std::string::npos);
    EXPECT_NE(content(testing::recording_fault()).find("The recording is at fault"), std::string::npos);
}

TEST(DiagnosisReport, AWrongValueIsNothingLeftOut) {
    Diagnosis diagnosis = testing::explained();
    diagnosis.omitted[0].instance = {.effect = "parameter-error",
                                     .values = {{"factor", 1.4}},
                                     .choices = {{"parameter", "track.pads.stiffness_n_per_m"}}};
    EXPECT_NE(content(diagnosis).find(
                  "<h1>Nothing is left out: track.pads.stiffness_n_per_m is 1.4 times what was believed.</h1>"),
              std::string::npos);
}

TEST(DiagnosisReport, MarksThePlaceInTheDrawing) {
    const std::string page = content(testing::unexplained());
    EXPECT_NE(page.find("class=\"part support hot\" opacity=\"0.78\""), std::string::npos);
    EXPECT_EQ(page.find("part wheel hot"), std::string::npos);
    EXPECT_EQ(content(testing::consistent()).find(" hot\" opacity"), std::string::npos);
    const std::string fault = content(testing::recording_fault());
    EXPECT_NE(fault.find("sensor hot\" opacity=\"1.00\"><path d=\"M216 130l6 6l-6 6l-6 -6z\"/></g>"), std::string::npos)
        << "bogie_2 alone";
}

TEST(DiagnosisReport, ShowsTheChannelOfTheMostCertainMismatch) {
    EXPECT_EQ(report::worst_channel(testing::explained()), 9u) << "axlebox_1 of run_80";
    Diagnosis diagnosis = testing::consistent();
    diagnosis.channels[3].band_believed_db.assign(diagnosis.channels[3].band_centre_hz.size(), -9.0);
    EXPECT_EQ(report::worst_channel(diagnosis), 3u) << "without any: the largest differences";
}

TEST(DiagnosisReport, DrawsNoMoreThanIsSeenAndAllOfTheLaws) {
    const nlohmann::json charts = data(testing::explained());
    EXPECT_EQ(charts["channels"].size(), 18u);
    EXPECT_EQ(charts["channels"][0]["sets"].size(), 6u) << "band, recorded, three models";
    EXPECT_EQ(charts["channels"][0]["sets"][0]["y"].size(), charts["channels"][0]["f"].size());
    EXPECT_LT(charts["channels"][0]["f"].size(), 800u);
    EXPECT_EQ(charts["charts"].size(), 2u) << "real and imaginary part of the pad";
    EXPECT_EQ(data(testing::consistent())["channels"][0]["sets"].size(), 5u) << "nothing was diagnosed";
}

TEST(ReportWords, Numbers) {
    EXPECT_EQ(report::percent(0.9741), "97 %");
    EXPECT_EQ(report::percent(0.998), "99.8 %");
    EXPECT_EQ(report::percent(0.99999), "&gt; 99.9 %");
    EXPECT_EQ(report::percent(0.0), "0 %");
    EXPECT_EQ(report::percent(1.0), "100 %");
    EXPECT_EQ(report::percent(1e-9), "&lt; 0.1 %");
    EXPECT_EQ(report::percent(std::nan("")), "–");
    EXPECT_EQ(report::figure(1770.2), "1770");
    EXPECT_EQ(report::figure(0.1512), "0.151");
    EXPECT_EQ(report::figure(9.0e7), "9e7");
    EXPECT_EQ(report::figure(-6.339e-8), "-6.34e-8");
    EXPECT_EQ(report::figure(99960.0), "1e5") << "rounded first";
    EXPECT_EQ(report::figure(0.0), "0");
    EXPECT_EQ(report::decibels(-0.042, true), "-0.04 dB");
    EXPECT_EQ(report::decibels(3.12, true), "+3.1 dB");
    EXPECT_EQ(report::chance(0.0), "&lt; 1e-12");
    EXPECT_EQ(report::sentence("a <b> is off"), "A &lt;b&gt; is off.");
}

TEST(ReportWords, LevelsThatSayNothingDoNotCount) {
    EXPECT_DOUBLE_EQ(report::rms_level_db({3.0, std::nan(""), -3.0}), 3.0);
    EXPECT_TRUE(std::isnan(report::rms_level_db({std::nan("")})));
}

}  // namespace
}  // namespace railpem::app
