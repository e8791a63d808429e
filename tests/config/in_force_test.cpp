// Where configuration is found, what it builds on, and what comes of it for a model.
#include "config/in_force.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "config/fault.h"
#include "config/sidecar.h"
#include "tests/support/fresh_folder.h"
#include "validate/registry.h"

namespace rad::config {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Configured : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = tests::fresh_folder();
    fs::create_directories(folder_ / "a/b");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  [[nodiscard]] InForce at(const std::string& model, const Settings& command_line = {}) {
    chain_ = ConfigSearch().of_folder((folder_ / model).parent_path());
    return in_force(chain_, folder_ / model, command_line);
  }

  [[nodiscard]] std::string fault_at(const std::string& folder) const {
    try {
      ConfigSearch().of_folder(folder_ / folder);
    } catch (const ConfigFault& fault) {
      return fault.what();
    }
    return "none";
  }

  static RuleInForce rule(const InForce& in_force, std::string_view id) {
    for (const RuleInForce& it : in_force.rules) {
      if (it.rule->id == id) return it;
    }
    throw std::logic_error("no such rule");
  }

  static std::size_t line_of(const Origin& origin) { return origin.line; }

  fs::path folder_;
  Chain chain_;
};

TEST_F(Configured, NearestFileUpwardCounts) {
  write("radlint.toml", "units = \"mm\"\n");
  write("a/.radlint.toml", "units = \"cm\"\n");
  EXPECT_EQ(at("x.obj").metres_per_unit->value, 0.001);
  EXPECT_EQ(at("a/b/x.obj").metres_per_unit->value, 0.01);
  write("a/b/radlint.toml", "up = \"z\"\n");
  EXPECT_FALSE(at("a/b/x.obj").metres_per_unit) << "files are not joined unless one extends the other";
  write("a/radlint.toml", "units = \"in\"\n");
  EXPECT_EQ(at("a/x.obj").metres_per_unit->value, 0.0254) << "radlint.toml before .radlint.toml";
  EXPECT_TRUE(ConfigSearch({}, true).of_folder(folder_ / "a").empty());
  EXPECT_EQ(ConfigSearch(folder_ / "radlint.toml").of_folder(folder_ / "a/b").size(), 1U);
}

TEST_F(Configured, ExtendingFilesComeLaterAndWin) {
  write("base.toml", "units = \"mm\"\nup = \"y\"\nignore = [\"RL005\"]\n");
  write("a/radlint.toml", "extend = \"../base.toml\"\nunits = \"ft\"\nextend-ignore = [\"RL004\"]\n");
  const InForce it = at("a/b/x.obj");
  EXPECT_EQ(it.metres_per_unit->value, 0.3048);
  EXPECT_EQ(it.up->value, scene::UpAxis::Y);
  EXPECT_THAT(it.up->origin.text(), testing::EndsWith("base.toml:2"));
  EXPECT_FALSE(rule(it, "RL005").on);
  EXPECT_FALSE(rule(it, "RL004").on);
  write("a/radlint.toml", "extend = \"../base.toml\"\nignore = [\"RL004\"]\n");
  EXPECT_TRUE(rule(at("a/x.obj"), "RL005").on) << "ignore replaces what was ignored";
}

TEST_F(Configured, CirclesAndWhatHasNoEndAreRefused) {
  write("radlint.toml", "extend = \"a/x.toml\"\n");
  write("a/x.toml", "\nextend = \"../radlint.toml\"\n");
  EXPECT_THAT(fault_at(""), testing::AllOf(HasSubstr("x.toml:2: extend:"), HasSubstr("extended by itself")));
  write("radlint.toml", "extend = \"radlint.toml\"\n");
  EXPECT_THAT(fault_at(""), HasSubstr("extended by itself"));
  write("radlint.toml", "extend = \"none.toml\"\n");
  EXPECT_THAT(fault_at(""), HasSubstr("radlint.toml:1: extend: there is no file 'none.toml'"));
  write("radlint.toml", "extend = \"a\"\n");
  EXPECT_THAT(fault_at(""), HasSubstr("there is no file 'a'"));
  for (int i = 0; i < 40; ++i) write(std::to_string(i) + ".toml", "extend = \"" + std::to_string(i + 1) + ".toml\"\n");
  write("radlint.toml", "extend = \"0.toml\"\n");
  EXPECT_THAT(fault_at(""), HasSubstr("more than 16 files in a row"));
  for (int i = 0; i < 12; ++i) {
    const std::string next = "\"" + std::to_string(i + 1) + ".toml\"";
    write(std::to_string(i) + ".toml", "extend = [" + next + ", " + next + "]\n");
  }
  write("12.toml", "");
  EXPECT_THAT(fault_at(""), HasSubstr("more than 64 files"));
}

TEST_F(Configured, EntriesForFilesComeAfterTheTopOfTheirFile) {
  write("radlint.toml",
        "units = \"mm\"\n[[files]]\nfiles = \"a/**\"\nunits = \"cm\"\n[[files]]\nfiles = \"x.obj\"\nunits = \"in\"\n"
        "ignore = [\"RL503\"]\n");
  EXPECT_EQ(at("y.obj").metres_per_unit->value, 0.001);
  EXPECT_EQ(at("a/y.obj").metres_per_unit->value, 0.01);
  EXPECT_EQ(at("a/b/x.obj").metres_per_unit->value, 0.0254) << "of two the later";
  EXPECT_FALSE(rule(at("x.obj"), "RL503").on);
  EXPECT_TRUE(rule(at("y.obj"), "RL503").on);
  EXPECT_EQ(fitting_files(chain_, folder_ / "a/x.obj").size(), 2U);
}

TEST_F(Configured, TheCommandLineWins) {
  write("radlint.toml",
        "units = \"mm\"\nselect = [\"RL2\"]\nignore = [\"RL240\", \"RL223\"]\n[rules.RL201]\nseverity = \"note\"\n"
        "[rules.RL005]\nseverity = \"off\"\n");
  Settings said;
  said.metres_per_unit = {1.0, {"--units"}};
  said.rules[validate::find_rule("RL201")].severity = {scene::Severity::Warning, {"--severity"}};
  said.extend_select = {{"RL101", "RL240"}, {"--extend-select"}};
  const InForce it = at("x.obj", said);
  EXPECT_EQ(it.metres_per_unit->origin.text(), "--units");
  EXPECT_EQ(rule(it, "RL201").severity->value, scene::Severity::Warning);
  EXPECT_TRUE(rule(it, "RL101").on);
  EXPECT_TRUE(rule(it, "RL240").on) << "selected later than ignored";
  EXPECT_FALSE(rule(it, "RL223").on);
  EXPECT_FALSE(rule(it, "RL102").on);
  EXPECT_EQ(line_of(rule(it, "RL102").on_origin), 2U);
  EXPECT_EQ(line_of(rule(it, "RL223").on_origin), 3U);
  said.ignore = {{"RL210"}, {"--ignore"}};
  EXPECT_TRUE(rule(at("x.obj", said), "RL223").on) << "--ignore replaces";
  said.select = {{"ALL"}, {"--select"}};
  EXPECT_TRUE(rule(at("x.obj", said), "RL102").on);
  EXPECT_FALSE(rule(at("x.obj", said), "RL005").on) << "off is a severity, and the command line gives none";
}

TEST_F(Configured, ThresholdsAndSeveritiesReachTheLint) {
  write("radlint.toml",
        "tolerance = \"1mm\"\n[rules.RL240]\nmin-shape = 0.5\nseverity = \"error\"\n[[objects]]\nobjects = \"rug*\"\n"
        "ignore = \"RL221\"\nrules = { RL110 = \"note\", RL240 = { severity = \"warning\", min-shape = 0.1 } }\n");
  const validate::LintOptions options = lint_options(at("x.obj"));
  const validate::Rule& shape = *validate::find_rule("RL240");
  EXPECT_EQ(options.parameters.of(shape, "min-shape"), 0.5);
  EXPECT_EQ(options.severities.at(&shape), scene::Severity::Error);
  EXPECT_EQ(options.tolerance->value, 0.001);
  ASSERT_EQ(options.waivers.size(), 1U);
  EXPECT_EQ(options.waivers[0].scope, scene::WaiverScope::Names);
  EXPECT_EQ(options.waivers[0].origin, scene::WaiverOrigin::Configuration);
  ASSERT_EQ(options.named_severities.size(), 2U);
  for (const validate::NamedSeverity& named : options.named_severities) {
    EXPECT_EQ(named.severity, named.rule == &shape ? scene::Severity::Warning : scene::Severity::Note);
  }
  ASSERT_EQ(options.named_thresholds.size(), 1U);
  EXPECT_EQ(options.named_thresholds[0].rule, &shape);
  EXPECT_EQ(options.named_thresholds[0].parameter, "min-shape");
  EXPECT_EQ(options.named_thresholds[0].value, 0.1);
}

TEST_F(Configured, ExcludedPathsAreBelowTheirFile) {
  write("radlint.toml", "exclude = [\"legacy\", \"a/*.obj\"]\n");
  static_cast<void>(at("x.obj"));
  EXPECT_TRUE(excludes(chain_, folder_ / "a/legacy"));
  EXPECT_TRUE(excludes(chain_, folder_ / "a/y.obj"));
  EXPECT_FALSE(excludes(chain_, folder_ / "y.obj"));
}

TEST_F(Configured, Sidecars) {
  const std::string path = sidecar_path((folder_ / "room.stl").string());
  EXPECT_TRUE(read_sidecar(path).empty());
  write("room.stl.radlint.toml",
        "[[suppress]]\nrules = [\"RL221\"]\nobjects = [\"rug*\"]\nreason = \"a rug\"\n\n[[suppress]]\nrules = "
        "\"RL005\"\n");
  const auto waivers = read_sidecar(path);
  ASSERT_EQ(waivers.size(), 2U);
  EXPECT_EQ(waivers[0].scope, scene::WaiverScope::Names);
  EXPECT_EQ(waivers[0].reason, "a rug");
  EXPECT_EQ(waivers[1].scope, scene::WaiverScope::File);
  EXPECT_EQ(waivers[1].place.line, 6U);
  EXPECT_EQ(waivers[1].origin, scene::WaiverOrigin::Sidecar);
  for (const char* text :
       {"[[supress]]\nrules = \"RL1\"\n", "[[suppress]]\nobjects = \"a\"\n", "suppress = 1\n", "=\n"}) {
    write("room.stl.radlint.toml", text);
    ASSERT_EQ(read_sidecar(path).size(), 1U);
    EXPECT_NE(read_sidecar(path)[0].fault, "");
  }
  write("room.stl.radlint.toml", "[[supress]]\nrules = \"RL1\"\n");
  EXPECT_THAT(read_sidecar(path)[0].fault, HasSubstr("did you mean suppress?"));
}

}  // namespace
}  // namespace rad::config
