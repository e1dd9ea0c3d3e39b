#include "core/files/yaml_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/reading.hpp"

namespace lookout::core {
namespace {

using testing::error_of;

TEST(YamlReader, ReadsEachKind) {
  const auto map =
      YamlMap::load_text("a: 1.5\nb: 3\nc: yes\nd: word\ne: [1, 2]\nf: {g: 4}\nh: [{i: 5}]\n", "t.yaml");
  EXPECT_DOUBLE_EQ(map.number("a", 0.0), 1.5);
  EXPECT_EQ(map.integer("b", 0), 3);
  EXPECT_TRUE(map.flag("c", false));
  EXPECT_EQ(map.text("d", ""), "word");
  EXPECT_EQ(map.numbers("e"), (std::vector<double>{1, 2}));
  EXPECT_DOUBLE_EQ(map.map("f")->number("g", 0), 4.0);
  EXPECT_DOUBLE_EQ(map.maps("h").at(0).number("i", 0), 5.0);
  EXPECT_NO_THROW(map.finish());
}

TEST(YamlReader, AbsentKeysGiveTheFallback) {
  const auto map = YamlMap::load_text("", "t.yaml");
  EXPECT_DOUBLE_EQ(map.number("a", 2.0), 2.0);
  EXPECT_FALSE(map.map("m"));
  EXPECT_NO_THROW(map.finish());
}

TEST(YamlReader, UnknownKeyNamesLineColumnAndAcceptedKeys) {
  const auto map = YamlMap::load_text("range: 5\nragne: 6\n", "t.yaml");
  map.number("range", 0.0);
  EXPECT_EQ(error_of([&] { map.finish(); }), "t.yaml:2:1: unknown key `ragne`, accepted: range");
}

// yaml-cpp names the letter that it does not know as an escape, whatever it is. Found by the fuzz target
// scene.
TEST(YamlReader, ADamagedEscapeIsRefusedInOneLineOfText) {
  for (const char letter : {'\1', '\v', '\x7f', '\xff', 'q'}) {
    const std::string error = error_of(
        [&] { YamlMap::load_text(std::string("a: \"\\").append(1, letter).append("\"\n"), "t.yaml"); });
    EXPECT_EQ(error.substr(0, 11), "t.yaml:1:7:");
    EXPECT_TRUE(std::all_of(error.begin(), error.end(), [](char c) { return c >= ' ' && c <= '~'; }))
        << error;
  }
}

// On these yaml-cpp 0.7 makes documents of nothing until memory ends. Found by the fuzz target scene.
TEST(YamlReader, ASignAtTheBeginThatCannotStandThereIsRefused) {
  for (const char* text : {", a: 1\n", "] a\n", "}", "a: 1\n---\n, b: 2\n"})
    EXPECT_NE(error_of([&] { YamlMap::load_text(text, "t.yaml"); }).find("t.yaml:"), std::string::npos)
        << text;
  EXPECT_NO_THROW(YamlMap::load_text("---\n---\n---\n", "t.yaml"));
}

TEST(YamlReader, ValueOfAnotherKindIsRefused) {
  const auto map = YamlMap::load_text("range: 150m\n", "t.yaml");
  EXPECT_EQ(error_of([&] { map.number("range", 0.0, kPositive); }),
            "t.yaml:1:8: range: got `150m`, expected a number > 0");
}

TEST(YamlReader, ValueOutOfRangeIsRefused) {
  const auto map = YamlMap::load_text("p: 1.5\nn: .nan\n", "t.yaml");
  EXPECT_EQ(error_of([&] { map.number("p", 0.0, kProbability); }),
            "t.yaml:1:4: p: got `1.5`, expected a number >= 0 <= 1");
  EXPECT_NE(error_of([&] { map.number("n", 0.0); }).find("expected a finite number"), std::string::npos);
}

TEST(YamlReader, WholeNumberIsRequiredForIntegers) {
  const auto map = YamlMap::load_text("n: 2.5\n", "t.yaml");
  EXPECT_EQ(error_of([&] { map.integer("n", 0); }), "t.yaml:1:4: n: got `2.5`, expected a whole number");
}

TEST(YamlReader, BrokenYamlNamesTheLine) {
  EXPECT_NE(error_of([] { YamlMap::load_text("a: [1, 2\nb: 3\n", "t.yaml"); }).find("t.yaml:2"),
            std::string::npos);
}

TEST(YamlReader, DuplicateKeyAndMissingFileAreRefused) {
  EXPECT_EQ(error_of([] { YamlMap::load_text("a: 1\na: 2\n", "t.yaml"); }),
            "t.yaml:2:1: key `a` is given twice");
  EXPECT_NE(error_of([] { YamlMap::load_file("/nowhere.yaml"); }).find("cannot be read"), std::string::npos);
}

TEST(YamlReader, DuplicateKeysAreRefusedAtAnyDepth) {
  EXPECT_EQ(error_of([] { YamlMap::load_text("m:\n  a: 1\n  a: 2\n", "t.yaml"); }),
            "t.yaml:3:3: key `a` is given twice");
  EXPECT_EQ(error_of([] { YamlMap::load_text("l: [{a: 1, a: 2}]\n", "t.yaml"); }),
            "t.yaml:1:12: key `a` is given twice");
}

TEST(YamlReader, ASecondDocumentIsRefusedWithItsLine) {
  EXPECT_EQ(error_of([] { YamlMap::load_text("a: 1\n---\na: 2\n", "t.yaml"); }),
            "t.yaml:3:1: a second document; expected one in the file");
  EXPECT_NO_THROW(YamlMap::load_text("---\na: 1\n...\n", "t.yaml"));
}

TEST(YamlReader, MergeKeysBringTheKeysThatAMappingLacks) {
  const auto map = YamlMap::load_text("base: &b {x: 1, y: 2}\nm:\n  <<: *b\n  y: 3\n", "t.yaml");
  const auto merged = map.map("m");
  EXPECT_DOUBLE_EQ(merged->number("x", 0.0), 1.0);
  EXPECT_DOUBLE_EQ(merged->number("y", 0.0), 3.0);
  EXPECT_NO_THROW(merged->finish());
  EXPECT_NO_THROW(map.finish());  // What is merged elsewhere may have a name of its own.
  EXPECT_NE(error_of([] {
              YamlMap::load_text("m: {<<: 3}\n", "t.yaml");
            }).find("t.yaml:1:9: <<: expected a mapping"),
            std::string::npos);
}

TEST(YamlReader, AnAliasOfItselfIsRefused) {
  EXPECT_NE(error_of([] { YamlMap::load_text("a: &a {b: *a}\n", "t.yaml"); }).find("refers to itself"),
            std::string::npos);
}

TEST(YamlReader, ATabInTheIndentationIsNamedWithItsLine) {
  for (const char* text : {"a:\n\tb: 1\n", "a:\n  b: 1\n \tc: 2\n"})
    EXPECT_NE(error_of([&] {
                YamlMap::load_text(text, "t.yaml");
              }).find(":1: a tab in the indentation, expected blanks"),
              std::string::npos);
  EXPECT_DOUBLE_EQ(YamlMap::load_text("a:\t1\n", "t.yaml").number("a", 0.0),
                   1.0);  // There YAML has them.
}

TEST(YamlReader, ADirectoryIsRefused) {
  EXPECT_NE(error_of([] { YamlMap::load_file("/tmp"); }).find("/tmp: is a directory"), std::string::npos);
}

TEST(YamlReader, ChoiceListsWhatIsAccepted) {
  const auto map = YamlMap::load_text("clutter: heavy\n", "t.yaml");
  EXPECT_EQ(error_of([&] {
              map.choice("clutter", "literal", {"literal", "light"});
            }),
            "t.yaml:1:10: clutter: got `heavy`, expected one of: literal light");
}

}  // namespace
}  // namespace lookout::core
