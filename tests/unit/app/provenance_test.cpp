#include "app/provenance.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/key_depth.hpp"
#include "app/sha256.hpp"
#include "program_in_process.hpp"

namespace railpem::app {
namespace {

/// Test vectors of FIPS 180-4, and the lengths around a block.
TEST(Sha256, GivesTheKnownDigests) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Provenance, QuotesForAShell) {
    EXPECT_EQ(shell_quoted("case.toml"), "case.toml");
    EXPECT_EQ(shell_quoted("run 1"), "'run 1'");
    EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_quoted("a=[1, 2]"), "'a=[1, 2]'");
    EXPECT_EQ(shell_quoted(""), "''");
}

TEST(Provenance, StandsWhereReadersOfEachKindLeaveItAlone) {
    const Provenance from{.program = "railpem 1.2",
                          .command = "railpem solve 'a--b.toml'",
                          .set = {"x=1"},
                          .inputs = {{"a--b.toml", "12"}}};
    EXPECT_EQ(
        stamped("t.csv", "a\n1\n", from),
        "a\n1\n# written by railpem 1.2; command: railpem solve 'a--b.toml'; set: x=1; input: a--b.toml sha256 12\n");
    EXPECT_TRUE(stamped("t.toml", "a = 1\n", from).starts_with("# written by railpem 1.2"));
    const auto json = nlohmann::json::parse(stamped("t.json", "{\n  \"a\": {\"b\": 1}\n}\n", from));
    EXPECT_EQ(json["a"]["b"], 1);
    EXPECT_EQ(json["provenance"]["command"], from.command);
    EXPECT_EQ(json["provenance"]["inputs"][0]["sha256"], "12");
    EXPECT_EQ(nlohmann::json::parse(stamped("t.json", "{}\n", from))["provenance"]["set"][0], "x=1");
    const std::string page = stamped("t.html", "<!DOCTYPE html>\n<html></html>\n", from);
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>\n<!-- written by railpem 1.2"));
    EXPECT_EQ(page.find("a--b"), std::string::npos);  // would end the comment
}

TEST(Overwriting, RefusesInputsAndFilesOfOthers) {
    const Scratch folder;
    folder.write("case.psd.csv", "frequency_hz,mine\n1,2\n");
    folder.write("case.toml", folder.read("nothing"));
    std::filesystem::copy_file(shipped("wei2016/case1.toml"), folder.path("case.toml"),
                               std::filesystem::copy_options::overwrite_existing);
    const std::vector<std::string> solve{"solve", folder.path("case.toml"), "--out", folder.path("."),
                                         "--set", "frequency.step_hz=5"};
    const ProgramResult foreign = run(solve);
    EXPECT_EQ(foreign.status, 2);
    EXPECT_NE(foreign.message.find("--force"), std::string::npos) << foreign.message;
    EXPECT_EQ(folder.read("case.psd.csv"), "frequency_hz,mine\n1,2\n");
    std::vector<std::string> forced = solve;
    forced.push_back("--force");
    EXPECT_EQ(run(forced).status, 0);
    EXPECT_EQ(run(solve).status, 0) << "its own results it writes over";
    const ProgramResult truth = run({"simulate", folder.path("case.toml"), "--seconds", "1", "--seed", "1", "--out",
                                     folder.path("out"), "--truth", folder.path("case.toml"), "--force"});
    EXPECT_EQ(truth.status, 2) << "an input, whatever is said";
    EXPECT_NE(truth.message.find("is an input of this run"), std::string::npos) << truth.message;
}

TEST(KeyDepth, FindsDeepKeysAndNothingElse) {
    std::string deep = "a";
    for (int i = 0; i < 40; ++i) deep += ".a";
    EXPECT_EQ(line_of_deep_key("x = 1\n" + deep + " = 1\n"), 2u);
    EXPECT_EQ(line_of_deep_key("[" + deep + "]\n"), 1u);
    EXPECT_EQ(line_of_deep_key("x = {" + deep + " = 1}\n"), 1u);
    std::string quoted = "\"a\"", spaced = "a";
    for (int i = 0; i < 40; ++i) quoted += ".'a'", spaced += " . a";
    EXPECT_EQ(line_of_deep_key(quoted + " = 1\n"), 1u);
    EXPECT_EQ(line_of_deep_key(spaced + " = 1\n"), 1u);
    EXPECT_FALSE(line_of_deep_key("# " + deep + "\nx = \"" + deep + "\"\ny = '''\n" + deep + "\n'''\n"));
    std::string numbers = "x = [1.5";
    for (int i = 0; i < 100; ++i) numbers += ", 1.5";
    EXPECT_FALSE(line_of_deep_key(numbers + "]\n"));
}

}  // namespace
}  // namespace railpem::app
