#include "cli/completion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/options.h"

namespace rad::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ListedChoices, AreWordsOfADescription) {
  EXPECT_THAT(listed_choices("text (default), json, leak-line"), ElementsAre("text", "json", "leak-line"));
  EXPECT_THAT(listed_choices("Unit of the file: m, cm"), ElementsAre("m", "cm"));
  EXPECT_THAT(listed_choices("Leave these out; repair: the first four"), IsEmpty());
  EXPECT_THAT(listed_choices("0.5mm, 0.5 (file units), auto"), IsEmpty());
  EXPECT_THAT(listed_choices("Threads; all by default"), IsEmpty());
  EXPECT_THAT(listed_choices("one"), IsEmpty());
}

std::string script_of(const std::vector<std::string>& args) {
  const auto parsed = parse_radlint(args);
  return std::holds_alternative<Stop>(parsed) ? std::get<Stop>(parsed).out : std::string();
}

TEST(Completion, ListsOptionsValuesAndRules) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const std::string script = script_of({"--completion", shell});
    for (const char* word : {"stage", "preprocess", "leak-line=", "RL201", "t-vertex", "rules"}) {
      EXPECT_THAT(script, HasSubstr(word)) << shell;
    }
  }
}

TEST(Completion, OfRadfix_NamesStages) {
  const auto parsed = parse_radfix(std::vector<std::string>{"--completion=fish"});
  EXPECT_THAT(std::get<Stop>(parsed).out, HasSubstr("-l until -x -a 'grouper isect"));
}

TEST(Completion, OfAnotherShell_IsAUsageError) {
  const auto parsed = parse_radlint(std::vector<std::string>{"--completion", "tcsh"});
  EXPECT_EQ(std::get<Stop>(parsed).exit_code, 2);
  EXPECT_THAT(std::get<Stop>(parsed).err, HasSubstr("'tcsh'"));
}

}  // namespace
}  // namespace rad::cli
