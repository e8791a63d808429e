#include "cli/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/nearest.h"

namespace rad::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

LintCommand lint_command(const std::vector<std::string>& args) { return std::get<LintCommand>(parse_radlint(args)); }

Stop stop_of(const std::vector<std::string>& args) { return std::get<Stop>(parse_radlint(args)); }

void expect_usage_error(const std::vector<std::string>& args, const std::string& words) {
  const auto parsed = parse_radlint(args);
  ASSERT_TRUE(std::holds_alternative<Stop>(parsed)) << words;
  EXPECT_EQ(std::get<Stop>(parsed).exit_code, 2);
  EXPECT_THAT(std::get<Stop>(parsed).err, HasSubstr(words));
  EXPECT_EQ(std::get<Stop>(parsed).out, "");
}

TEST(Options, Defaults) {
  const LintCommand command = lint_command({"a.obj"});
  EXPECT_THAT(command.paths, ElementsAre("a.obj"));
  EXPECT_EQ(command.format->name, "text");
  EXPECT_FALSE(command.stage);
  EXPECT_FALSE(command.fail_on);
  EXPECT_FALSE(command.settings.select);
  EXPECT_TRUE(command.settings.rules.empty());
  EXPECT_EQ(command.max_issues, 100U);
  EXPECT_TRUE(command.group);
}

TEST(Options, AllTogether) {
  const LintCommand command = lint_command({"--select=RL2,t-vertex",
                                            "--select",
                                            "RL1",
                                            "a.obj",
                                            "--ignore",
                                            "RL240",
                                            "--stage",
                                            "solve",
                                            "--fail-on",
                                            "note",
                                            "--tolerance",
                                            "0.5mm",
                                            "--units",
                                            "ft",
                                            "--up",
                                            "z",
                                            "-j2",
                                            "--no-group",
                                            "--max-issues",
                                            "0",
                                            "--max-findings=3",
                                            "--color=never",
                                            "--timings",
                                            "-q",
                                            "--format",
                                            "json",
                                            "--report",
                                            "json=a.json",
                                            "--report=text=b.txt",
                                            "b.obj"});
  EXPECT_THAT(command.paths, ElementsAre("a.obj", "b.obj"));
  EXPECT_THAT(command.select, ElementsAre("RL2", "t-vertex", "RL1"));
  EXPECT_THAT(command.ignore, ElementsAre("RL240"));
  EXPECT_EQ(command.stage, validate::Stage::Solve);
  EXPECT_EQ(command.fail_on, report::FailOn::Note);
  EXPECT_EQ(command.model.metres_per_unit, 0.3048);
  EXPECT_EQ(command.model.up, scene::UpAxis::Z);
  EXPECT_EQ(command.model.jobs, 2U);
  ASSERT_TRUE(command.model.tolerance);
  EXPECT_FALSE(command.group);
  EXPECT_EQ(command.max_issues, 0U);
  EXPECT_EQ(command.max_findings, 3U);
  EXPECT_EQ(command.color, ColorChoice::Never);
  EXPECT_TRUE(command.timings);
  EXPECT_TRUE(command.quiet);
  EXPECT_EQ(command.format->name, "json");
  ASSERT_EQ(command.reports.size(), 2U);
  EXPECT_EQ(command.reports[1].format->name, "text");
  EXPECT_EQ(command.reports[1].path, "b.txt");
  EXPECT_THAT(command.settings.select->value, ElementsAre("RL2", "t-vertex", "RL1"));
  EXPECT_THAT(command.settings.ignore->value, ElementsAre("RL240"));
  EXPECT_EQ(command.settings.metres_per_unit->origin.text(), "--units");
}

TEST(Options, OddFileNames) {
  EXPECT_THAT(lint_command({"rules.obj"}).paths, ElementsAre("rules.obj"));
  EXPECT_THAT(lint_command({"--", "-odd.obj"}).paths, ElementsAre("-odd.obj"));
}

TEST(Options, RuleCommands) {
  EXPECT_EQ(std::get<RuleCommand>(parse_radlint(std::vector<std::string>{"rules"})).id, "");
  const auto command =
      std::get<RuleCommand>(parse_radlint(std::vector<std::string>{"rule", "t-vertex", "--format", "markdown"}));
  EXPECT_EQ(command.id, "t-vertex");
  EXPECT_EQ(command.format, PageFormat::Markdown);
}

TEST(Options, UsageErrors) {
  expect_usage_error({}, "name a model file or a folder");
  expect_usage_error({"--fromat", "json", "a.obj"}, "unknown option --fromat; did you mean --format?");
  expect_usage_error({"a.obj", "--stage", "slove"},
                     "'slove' is none of model, preprocess, solve, display; did you mean solve?");
  expect_usage_error({"a.obj", "--select", "RL21X"}, "no rule is called 'RL21X'; did you mean RL2");
  expect_usage_error({"a.obj", "--ignore", "ALL"}, "leave no rule to check");
  expect_usage_error({"a.obj", "--tolerance", "tiny"}, "'tiny' is not a length");
  expect_usage_error({"a.obj", "--units", "yd"}, "'yd' is none of m, cm, mm, in, ft");
  expect_usage_error({"a.obj", "--jobs", "0"}, "--jobs: '0' is not a whole number of at least 1");
  expect_usage_error({"a.obj", "--max-issues", "some"}, "--max-issues");
  expect_usage_error({"a.obj", "--report", "r.json"}, "is not of the form format=path");
  expect_usage_error({"a.obj", "--report", "serif=r.json"}, "'serif' is none of text, concise, json, jsonl, sarif");
  expect_usage_error({"a.obj", "--report", "json=-"}, "--format chooses what standard output carries");
  expect_usage_error({"a.obj", "--format", "markdwon"}, "did you mean markdown?");
  expect_usage_error({"rule"}, "id");
}

TEST(Options, HelpNamesEveryExitCodeAndOption) {
  const Stop help = stop_of({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* words :
       {"--select",   "--ignore",     "--stage",        "--fail-on", "--tolerance", "--units", "--up",     "--jobs",
        "--no-group", "--max-issues", "--max-findings", "--color",   "--timings",   "--quiet", "--format", "--report",
        "--version",  "Examples:",    "Exit codes:",    "  0  ",     "  1  ",       "  2  ",   "  3  "}) {
    EXPECT_THAT(help.out, HasSubstr(words));
  }
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(Options, Version) {
  EXPECT_THAT(stop_of({"--version"}).out, testing::StartsWith("radlint " + std::string(report::tool_version()) + "\n"));
  EXPECT_EQ(stop_of({"--version"}).exit_code, 0);
}

FixCommand fix_command(const std::vector<std::string>& args) { return std::get<FixCommand>(parse_radfix(args)); }

void expect_fix_usage_error(const std::vector<std::string>& args, const std::string& words) {
  const auto parsed = parse_radfix(args);
  ASSERT_TRUE(std::holds_alternative<Stop>(parsed)) << words;
  EXPECT_EQ(std::get<Stop>(parsed).exit_code, 2);
  EXPECT_THAT(std::get<Stop>(parsed).err, HasSubstr(words));
}

TEST(FixOptions, Defaults) {
  const FixCommand command = fix_command({"a.glb", "-o", "b.obj"});
  EXPECT_EQ(command.input, "a.glb");
  EXPECT_EQ(command.output, "b.obj");
  EXPECT_EQ(command.filters, scene::kRepairFilters);
  EXPECT_FALSE(command.partial || command.dry_run || command.diff || command.in_place || command.unsafe_fixes);
  EXPECT_FALSE(command.timings);
  EXPECT_FALSE(command.patch_size || command.element_size || command.exposure);
  EXPECT_TRUE(command.reports.empty());
  EXPECT_EQ(command.preview, "");
}

TEST(FixOptions, AllTogether) {
  const FixCommand command = fix_command({"a.glb",    "--output",       "b.obj",   "--report",  "json=r.json",
                                          "--report", "sarif=r.sarif",  "--units", "mm",        "--jobs",
                                          "2",        "--tolerance",    "1e-5d",   "--skip",    "repair",
                                          "--solve",  "--patch-size",   "0.5",     "--timings", "--exposure",
                                          "1e-2",     "--element-size", "0.25",    "--preview", "b.png"});
  ASSERT_EQ(command.reports.size(), 2U);
  EXPECT_EQ(command.reports[0].path, "r.json");
  EXPECT_EQ(command.reports[1].format->name, "sarif");
  EXPECT_EQ(command.model.metres_per_unit, 0.001);
  EXPECT_EQ(command.model.jobs, 2U);
  EXPECT_TRUE(command.model.tolerance);
  EXPECT_FALSE(command.repairs());
  EXPECT_TRUE(command.solves());
  EXPECT_EQ(command.patch_size, 0.5);
  EXPECT_EQ(command.element_size, 0.25);
  EXPECT_EQ(command.exposure, 0.01);
  EXPECT_EQ(command.preview, "b.png");
  EXPECT_TRUE(command.timings);
}

TEST(FixOptions, SolveMeshesFirst) { EXPECT_TRUE(fix_command({"a.obj", "-o", "b.obj", "--solve"}).meshes()); }

TEST(FixOptions, StagesAreChosenByName) {
  using scene::Filter;
  using scene::FilterSet;
  const auto filters = [](std::vector<std::string> words) {
    words.insert(words.begin(), {"a.obj", "-o", "b.obj"});
    return fix_command(words).filters;
  };
  EXPECT_EQ(filters({"--until", "isect"}), (FilterSet{Filter::Grouper, Filter::Isect}));
  EXPECT_EQ(filters({"--only", "orient"}), FilterSet{Filter::Orient});
  EXPECT_EQ(filters({"--only", "orient,grouper"}), (FilterSet{Filter::Orient, Filter::Grouper}));
  EXPECT_EQ(filters({"--skip", "coplanar,orient"}), (FilterSet{Filter::Grouper, Filter::Isect}));
  EXPECT_EQ(filters({"--mesh"}), FilterSet::until(Filter::Emesh));
  EXPECT_EQ(filters({"--solve", "--skip", "emesh"}).has(Filter::Emesh), false);
  EXPECT_EQ(filters({"--until", "bake"}), FilterSet::until(Filter::Bake));
  EXPECT_EQ(filters({"--fix-only", "RL110"}), FilterSet{Filter::Orient});
  EXPECT_EQ(filters({"--fix-only", "RL211,inside-out-solid"}),
            (FilterSet{Filter::Grouper, Filter::Isect, Filter::Orient}));
}

TEST(FixOptions, WithoutNamesTheStandardStreamsAreMeant) {
  EXPECT_EQ(fix_command({}).input, "-");
  EXPECT_EQ(fix_command({}).output, "-");
  EXPECT_EQ(fix_command({"-", "-o", "b.obj"}).output, "b.obj");
  EXPECT_EQ(fix_command({"a.obj", "--dry-run"}).output, "");
  EXPECT_EQ(fix_command({"a.obj", "--in-place"}).output, "a.obj");
}
TEST(FixOptions, WhoIsSeenWhereFacesOverlap) {
  EXPECT_EQ(fix_command({"a.obj", "-o", "b.obj"}).coplanar.policy, repair::CoplanarPolicy::Paper);
  const auto coplanar = fix_command({"a.obj", "-o", "b.obj", "--coplanar-policy", "keep-last", "--priority", "rug*",
                                     "--priority", "floor", "--no-emitter-priority"})
                            .coplanar;
  EXPECT_EQ(coplanar.policy, repair::CoplanarPolicy::KeepLast);
  EXPECT_EQ(coplanar.priority, (std::vector<std::string>{"rug*", "floor"}));
  EXPECT_FALSE(coplanar.emitter_priority);
}

TEST(FixOptions, ToleranceCanBeChosenByTheProgram) {
  EXPECT_EQ(fix_command({"a.obj", "-o", "b.obj", "--tolerance", "auto"}).model.tolerance->measure,
            geom::ToleranceRequest::Measure::Auto);
}

TEST(FixOptions, UsageErrors) {
  const std::vector<std::string> files{"a.obj", "-o", "b.obj"};
  const auto refused = [&](std::vector<std::string> words, const std::string& why) {
    words.insert(words.begin(), files.begin(), files.end());
    expect_fix_usage_error(words, why);
  };
  expect_fix_usage_error({"a.obj"}, "-o is missing");
  expect_fix_usage_error({"--in-place"}, "standard input is no file");
  refused({"--report", "txt=r"}, "'txt' is none of text");
  refused({"--report", "r.json"}, "is not of the form format=path");
  refused({"--skip", "mesh"}, "--skip: there is no stage 'mesh'; did you mean pmesh?");
  refused({"--coplanar-policy", "layer"}, "'layer' is none of paper, area, priority, keep-first, keep-last");
  refused({"--coplanar-policy", "priority"}, "say which with --priority");
  refused({"--patch-size", "0"}, "--patch-size: '0' is not a number above 0");
  refused({"--patch-size", "-1"}, "--patch-size");
  refused({"--element-size", "half"}, "--element-size: 'half' is not a number above 0");
  refused({"--exposure", "inf"}, "--exposure: 'inf' is not a number above 0");
  refused({"--slove"}, "unknown option --slove; did you mean --solve?");
  refused({"--jobs", "0"}, "--jobs");
}

TEST(FixOptions, HelpNamesEveryExitCodeAndOption) {
  const auto help = std::get<Stop>(parse_radfix(std::vector<std::string>{"--help"}));
  EXPECT_EQ(help.exit_code, 0);
  for (const char* words : {"--output",
                            "--mesh",
                            "--solve",
                            "--skip",
                            "--patch-size",
                            "--element-size",
                            "--exposure",
                            "--preview",
                            "--report",
                            "--timings",
                            "--tolerance",
                            "--units",
                            "--jobs",
                            "--version",
                            "--only",
                            "--until",
                            "--fix-only",
                            "--unsafe-fixes",
                            "--check-contracts",
                            "--dry-run",
                            "--diff",
                            "--in-place",
                            "--annotate",
                            "Examples:",
                            "  0  ",
                            "  1  ",
                            "  2  ",
                            "  3  ",
                            "  4  ",
                            "--coplanar-policy",
                            "--priority",
                            "--no-emitter-priority",
                            "auto"}) {
    EXPECT_THAT(help.out, HasSubstr(words));
  }
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(Nearest, SuggestsOnlyWhatIsNear) {
  const std::vector<std::string_view> words = {"model", "solve", "display"};
  EXPECT_EQ(nearest("modle", words), "model");
  EXPECT_EQ(nearest("xyzzyx", words), "");
  EXPECT_EQ(did_you_mean(""), "");
}

}  // namespace
}  // namespace rad::cli
