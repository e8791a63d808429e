// Files of configuration, read and refused.
#include "config/config_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "config/fault.h"
#include "config/file_keys.h"
#include "config/sidecar.h"
#include "config/toml_tree.h"
#include "tests/support/fresh_folder.h"
#include "validate/registry.h"

namespace rad::config {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ConfigFile read(const std::string& text) { return config_of(text, "/models/radlint.toml", "radlint.toml"); }

std::string fault_of(const std::string& text) {
  try {
    read(text);
  } catch (const ConfigFault& fault) {
    return fault.what();
  }
  return "none";
}

constexpr const char* kEverything = R"(# a comment
extend = ["../base.toml", "more.toml"]
stage = "solve"
fail-on = "warning"
select = ["RL2", "open-boundary"]
ignore = ["RL240"]
extend-select = "RL005"
extend-ignore = ["RL004"]
exclude = ["legacy", "old/**"]
units = "mm"
up = "y"
tolerance = "0.5mm"
lod = 2.2

[rules.RL240]
severity = "warning"
min-shape = 0.15
[rules.t-vertex]
severity = "off"

[[files]]
files = ["site/*.obj", "vendor"]
units = "m"
tolerance = 0.25
ignore = ["RL503"]
rules = { RL501 = { severity = "note" } }

[[objects]]
objects = ["Curtain*"]
materials = ["cloth"]
ignore = ["RL101"]
rules = { RL113 = "note", RL112 = "off" }
reason = "thin on purpose"
)";

TEST(ConfigFile, EveryKeyIsUnderstood) {
  const ConfigFile file = read(kEverything);
  ASSERT_EQ(file.extends.size(), 2U);
  EXPECT_EQ(file.extends[1].value, "more.toml");
  EXPECT_EQ(file.extends[1].origin.text(), "radlint.toml:2");
  EXPECT_EQ(file.stage->value, validate::Stage::Solve);
  EXPECT_EQ(file.stage->origin.text(), "radlint.toml:3");
  EXPECT_EQ(file.fail_on->value, report::FailOn::Warning);
  EXPECT_THAT(file.settings.select->value, ElementsAre("RL2", "open-boundary"));
  EXPECT_THAT(file.settings.extend_select->value, ElementsAre("RL005"));
  EXPECT_THAT(file.settings.extend_ignore->value, ElementsAre("RL004"));
  ASSERT_EQ(file.exclude.size(), 2U);
  EXPECT_EQ(file.exclude[1].value.glob, "old/**");
  EXPECT_EQ(file.exclude[1].value.base, "/models");
  EXPECT_EQ(file.settings.metres_per_unit->value, 0.001);
  EXPECT_EQ(file.settings.up->value, scene::UpAxis::Y);
  EXPECT_EQ(file.settings.tolerance->value.measure, geom::ToleranceRequest::Measure::Metres);
  EXPECT_EQ(file.settings.level_of_detail->value, 2.2);
  const RuleSettings& shape = file.settings.rules.at(validate::find_rule("poor-shape"));
  EXPECT_EQ(shape.severity->value, scene::Severity::Warning);
  EXPECT_EQ(shape.parameters.at("min-shape").value, 0.15);
  EXPECT_EQ(shape.parameters.at("min-shape").origin.line, 17U);
  EXPECT_EQ(file.settings.rules.at(validate::find_rule("RL201")).severity->value, std::nullopt);
}

TEST(ConfigFile, EntriesForFilesAndObjects) {
  const ConfigFile file = read(kEverything);
  ASSERT_EQ(file.files.size(), 1U);
  const FilesEntry& files = file.files[0];
  EXPECT_TRUE(files.fits("/models/site/a.obj"));
  EXPECT_TRUE(files.fits("/models/x/vendor/b.obj"));
  EXPECT_FALSE(files.fits("/models/site/x/a.obj"));
  EXPECT_FALSE(files.fits("/elsewhere/vendor/a.obj"));
  EXPECT_EQ(files.settings.tolerance->value.measure, geom::ToleranceRequest::Measure::FileUnits);
  EXPECT_EQ(files.settings.tolerance->value.value, 0.25);
  EXPECT_EQ(files.settings.rules.at(validate::find_rule("RL501")).severity->value, scene::Severity::Note);
  ASSERT_EQ(file.objects.size(), 1U);
  EXPECT_THAT(file.objects[0].names.materials, ElementsAre("cloth"));
  EXPECT_THAT(file.objects[0].ignore, testing::UnorderedElementsAre("RL101", "RL112"));
  EXPECT_EQ(file.objects[0].severities.at(validate::find_rule("RL113")), scene::Severity::Note);
  EXPECT_EQ(file.objects[0].reason, "thin on purpose");
}

TEST(ConfigFile, UnknownKeysNameTheLineAndTheNearest) {
  EXPECT_EQ(fault_of("stage = \"model\"\nselct = [\"RL2\"]\n"),
            "radlint.toml:2: unknown key 'selct'; did you mean select?");
  EXPECT_EQ(fault_of("[rules.RL240]\nmin-shap = 0.1\n"),
            "radlint.toml:2: unknown key 'min-shap' of RL240 poor-shape; did you mean min-shape?");
  EXPECT_EQ(fault_of("\n[rules.t-vertx]\nseverity = \"note\"\n"),
            "radlint.toml:2: no rule is called 't-vertx'; did you mean t-vertex? (radlint rules lists all)");
  EXPECT_EQ(fault_of("[[files]]\nfiles = \"a\"\nunit = \"m\"\n"),
            "radlint.toml:3: unknown key 'unit' in [[files]]; did you mean units?");
  EXPECT_EQ(fault_of("[[objects]]\nobject = \"a\"\n"),
            "radlint.toml:2: unknown key 'object' in [[objects]]; did you mean objects?");
  EXPECT_EQ(fault_of("zzzzzzzzzzzzzzzzzzzzzzzz = 1\n"), "radlint.toml:1: unknown key 'zzzzzzzzzzzzzzzzzzzzzzzz'");
}

TEST(ConfigFile, WrongValuesNameTheLineAndWhatIsExpected) {
  EXPECT_THAT(fault_of("stage = \"solv\"\n"), HasSubstr("radlint.toml:1: stage: 'solv' is none of model, preprocess, "
                                                        "solve, display; did you mean solve?"));
  EXPECT_THAT(fault_of("stage = 3\n"), HasSubstr("a text in quotes is expected"));
  EXPECT_THAT(fault_of("fail-on = \"errors\"\n"), HasSubstr("did you mean error?"));
  EXPECT_THAT(fault_of("select = [\"RL2\",\n  7]\n"), HasSubstr("radlint.toml:2: select: a list of texts"));
  EXPECT_THAT(fault_of("select = [\"RL9x\"]\n"), HasSubstr("no rule is called 'RL9x'"));
  EXPECT_THAT(fault_of("units = \"yd\"\n"), HasSubstr("'yd' is none of m, cm, mm, in, ft"));
  EXPECT_THAT(fault_of("up = \"x\"\n"), HasSubstr("'x' is none of y, z"));
  EXPECT_THAT(fault_of("tolerance = \"thin\"\n"), HasSubstr("is not a length"));
  EXPECT_THAT(fault_of("tolerance = -1\n"), HasSubstr("a number above 0"));
  EXPECT_THAT(fault_of("tolerance = nan\n"), HasSubstr("a number above 0"));
  EXPECT_THAT(fault_of("lod = \"2\"\n"), HasSubstr("a number is expected"));
  EXPECT_THAT(fault_of("[rules.RL240]\nmin-shape = 2\n"),
              HasSubstr("radlint.toml:2: min-shape: min-shape of RL240 lies"));
  EXPECT_THAT(fault_of("[rules.RL240]\nseverity = \"fatal\"\n"), HasSubstr("is none of error, warning, note, off"));
  EXPECT_THAT(fault_of("rules = 3\n"), HasSubstr("a table is expected"));
  EXPECT_THAT(fault_of("files = [\"a\"]\n"), HasSubstr("tables are expected: [[files]]"));
  EXPECT_THAT(fault_of("[files]\nfiles = \"a\"\n"), HasSubstr("tables are expected: [[files]]"));
  EXPECT_THAT(fault_of("[[files]]\nunits = \"m\"\n"), HasSubstr("[[files]] names no files"));
  EXPECT_THAT(fault_of("[[objects]]\nignore = \"RL1\"\n"), HasSubstr("names no objects or materials"));
}

TEST(ConfigFile, TextThatIsNoToml) {
  EXPECT_THAT(fault_of("stage = \n"), HasSubstr("radlint.toml:1:"));
  EXPECT_THAT(fault_of("a = 1\na = 2\n"), HasSubstr("radlint.toml:2:"));
  EXPECT_NE(fault_of(std::string("\0\0\0", 3)), "none");
  EXPECT_THAT(fault_of("units = \"mm\"\nstage = \xEF\xA4\x80\n"),
              HasSubstr("radlint.toml:2: a letter that is not ASCII"));
  EXPECT_EQ(fault_of("\xEF\xBB\xBFunits = \"mm\" # \xC3\xA9\n"), "none") << "a byte order mark";
  EXPECT_THAT(fault_of("[[files]"), HasSubstr("radlint.toml:1:"));
  EXPECT_EQ(fault_of(""), "none");
}

TEST(ConfigFile, WhatIsNestedWithoutEndIsRefused) {
  std::string dotted = "a", header = "[a", arrays = "a = ", tables = "a = ";
  for (int i = 0; i < 200000; ++i) {
    dotted += ".a";
    header += ".a";
    arrays += '[';
    tables += "{a=";
  }
  EXPECT_THAT(fault_of(dotted + " = 1\n"), HasSubstr("a name of more than 16 parts"));
  EXPECT_THAT(fault_of(header + "]\n"), HasSubstr("a name of more than 16 parts"));
  EXPECT_THAT(fault_of("x = 'a\"b' # \"\n" + header + "]\n"), HasSubstr("radlint.toml:2: a name of more than"));
  EXPECT_THAT(fault_of("x = \"\"\"\n'\n\"\"\"\n" + dotted + " = 1\n"), HasSubstr("a name of more than"));
  EXPECT_NE(fault_of(arrays), "none");
  EXPECT_NE(fault_of(tables), "none");
}

TEST(ConfigFile, TextsKeepTheirLetters) {
  const ConfigFile file = read(
      "exclude = ['M\xC3\xB6"
      "bel 100%', \"50%41\\u00e9\", '\xff', \"\"\"%\"\"\"] # \xC3\xA9\n");
  ASSERT_EQ(file.exclude.size(), 4U);
  EXPECT_EQ(file.exclude[0].value.glob,
            "M\xC3\xB6"
            "bel 100%");
  EXPECT_EQ(file.exclude[1].value.glob, "50%41\xC3\xA9");
  EXPECT_EQ(file.exclude[2].value.glob, "\xff") << "names of files need not be UTF-8";
  EXPECT_EQ(file.exclude[3].value.glob, "%");
}

TEST(ConfigFile, DotsInTextsAndCommentsAreNoParts) {
  const std::string dots(100, '.');
  EXPECT_EQ(fault_of("exclude = [\"" + dots + "\", '" + dots + "'] # " + dots + "\n"), "none");
}

// Cut anywhere and with any byte changed, it is understood or refused.
TEST(ConfigFile, DamagedTextIsRefusedOrUnderstood) {
  const std::string whole = kEverything;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    fault_of(whole.substr(0, i));
    for (const char c : {'\0', '"', '[', ']', '\n', '=', '.', '\xff'}) {
      std::string changed = whole;
      changed[i] = c;
      fault_of(changed);
    }
  }
}

TEST(ConfigFile, LargeFilesAreNotRead) {
  const auto path = tests::fresh_folder() / "radlint.toml";
  std::ofstream(path) << std::string(kLargestFile + 1, '#');
  EXPECT_THROW(read_config_file(path), ConfigFault);
  std::ofstream(path) << std::string(kLargestFile - 1, '#') << '\n';
  EXPECT_NO_THROW(read_config_file(path));
  std::filesystem::remove(path);
  EXPECT_THROW(read_config_file(path), ConfigFault);
}

std::string text_of_file(const std::string& path) {
  std::ifstream stream(std::string(RAD_SOURCE_DIR) + "/" + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ConfigKeys, AreDocumented) {
  const std::string page = text_of_file("docs/configuration.md"), man = text_of_file("docs/man/radlint.toml.5.scd");
  std::vector<KeyText> keys = sidecar_keys();
  for (const ConfigTable table : {ConfigTable::Top, ConfigTable::Files, ConfigTable::Objects}) {
    for (const KeyText& key : keys_of(table)) keys.push_back(key);
  }
  for (const KeyText& key : keys) {
    const std::string name(key.name);
    EXPECT_THAT(page, HasSubstr("| `" + name + "` | ")) << name;
    EXPECT_THAT(man, HasSubstr("*" + name + "*")) << name;
    EXPECT_THAT(page, HasSubstr(std::string(key.what))) << name;
  }
}

TEST(ConfigKeys, EveryThresholdIsDocumented) {
  const std::string page = text_of_file("docs/configuration.md");
  for (const validate::Rule* rule : validate::all_rules()) {
    for (const validate::Parameter& parameter : rule->parameters) {
      EXPECT_THAT(page, HasSubstr("| " + std::string(rule->id) + " " + std::string(rule->alias) + " | `" +
                                  std::string(parameter.name) + "` | "));
    }
  }
}

}  // namespace
}  // namespace rad::config
