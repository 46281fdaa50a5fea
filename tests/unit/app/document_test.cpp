#include "app/schema/document.hpp"

#include <gtest/gtest.h>

namespace railpem::app {
namespace {

TEST(Document, KnowsWhereEveryKeyAndValueStands) {
    const Document document =
        parse_document("x.toml", "title = \"t\"\n\n[vehicle]\n  mass = -1.5  # é\n[[list]]\na = [1, 2.0]\n[[list]]\n");
    const Entry* vehicle = document.root.find("vehicle");
    ASSERT_NE(vehicle, nullptr);
    EXPECT_EQ(vehicle->node.place.line, 3u);
    EXPECT_EQ(vehicle->node.place.length, 9u);
    const Entry* mass = vehicle->node.find("mass");
    ASSERT_NE(mass, nullptr);
    EXPECT_EQ(mass->place.line, 4u);
    EXPECT_EQ(mass->place.column, 3u);
    EXPECT_EQ(mass->node.place.column, 10u);
    EXPECT_EQ(mass->node.place.length, 4u);
    EXPECT_DOUBLE_EQ(mass->node.number, -1.5);
    const Node& list = document.root.find("list")->node;
    ASSERT_EQ(list.elements.size(), 2u);
    EXPECT_EQ(list.elements[0].place.line, 5u);
    EXPECT_EQ(list.elements[1].place.line, 7u);
    EXPECT_EQ(list.elements[0].find("a")->node.elements[1].place.column, 9u);
}

TEST(Document, KeepsTheOrderOfTheFile) {
    const Document document = parse_document("x.toml", "zebra = 1\napple = 2\nmango = 3\n");
    std::string order;
    for (const Entry& entry : document.root.entries) order += entry.key + " ";
    EXPECT_EQ(order, "zebra apple mango ");
}

TEST(Document, ReadsWindowsLineEnds) {
    const Document document = parse_document("x.toml", "a = 1\r\nb = 2\r\n");
    EXPECT_EQ(document.lines[0], "a = 1");
    EXPECT_EQ(document.root.find("b")->place.line, 2u);
}

TEST(OptionValue, IsTomlOrANumberOrABareWord) {
    const Place place{.option = "--set k=v"};
    EXPECT_EQ(parse_option_value("38500", place).kind, NodeKind::integer);
    EXPECT_EQ(parse_option_value("true", place).kind, NodeKind::boolean);
    EXPECT_DOUBLE_EQ(parse_option_value("1.5e-3", place).number, 1.5e-3);
    EXPECT_DOUBLE_EQ(parse_option_value(".5", place).number, 0.5);
    EXPECT_EQ(parse_option_value("modal", place).text, "modal");
    EXPECT_EQ(parse_option_value("\"a b\"", place).text, "a b");
    const Node list = parse_option_value("[10, 22.2]", place);
    ASSERT_EQ(list.elements.size(), 2u);
    EXPECT_EQ(list.elements[1].place.option, "--set k=v");
}

TEST(OptionValue, RefusesWhatIsNeither) {
    for (const char* text : {"", "a b", "[1, 2", "1\nother = 2"})
        EXPECT_THROW(parse_option_value(text, {.option = "--set k=v"}), InputError) << text;
}

TEST(InputErrorText, ShowsOnlyThePartOfALongLineAroundTheCaret) {
    const std::string line = std::string(500, 'a') + "bad" + std::string(500, 'c');
    const InputError error = input_error("x.toml", line, {.line = 7, .column = 501, .length = 3}, {.what = "wrong"});
    const std::string message = error.what();
    EXPECT_EQ(message, "x.toml:7:501: wrong\n  7 | " + std::string(50, 'a') + "bad" + std::string(47, 'c') +
                           "\n    | " + std::string(50, ' ') + "^^^");
}

TEST(InputErrorText, PutsTheCaretUnderTheRightLetterAfterTabsAndAccents) {
    const InputError error =
        input_error("x.toml", "\té = 1 = 2", {.line = 1, .column = 8, .length = 1}, {.what = "wrong"});
    EXPECT_STREQ(error.what(), "x.toml:1:8: wrong\n  1 |  é = 1 = 2\n    |        ^");
}

}  // namespace
}  // namespace railpem::app
