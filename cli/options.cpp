#include "cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "cli/exit_code.h"
#include "cli/nearest.h"
#include "cli/option_values.h"

namespace rad::cli {

namespace {

constexpr const char* kRadlintFooter = R"(Examples:
  radlint room.obj                          judge a model
  radlint models/ --report json=lint.json   judge a folder, keep a report
  radlint --stage solve --select RL2 a.glb  what a solver asks of the mesh
  radlint rule RL201                        what a rule means

Exit codes:
  0  nothing at or above --fail-on
  1  findings at or above --fail-on
  2  usage error, a path that does not exist, a report that cannot be written
  3  judged in part only: a limit was hit)";

constexpr const char* kRadfixFooter = R"(Examples:
  radfix house.obj -o house.glb               repair it
  radfix house.obj -o mesh.ply --mesh         and mesh it
  radfix house.obj -o lit.glb --solve --preview lit.png
                                              and light it, with a picture
  radfix house.obj --dry-run --diff           what would be done, and where
  radfix --only grouper < a.stage.json | radfix --only isect > b.stage.json
                                              filter by filter

Formats: .obj .ply .stl .off .glb .gltf, and .stage.json for a model between two
stages. Standard output (-) carries a stage file.

Exit codes:
  0  written, read back, and clean at the stage that was asked for
  1  written, but errors remain; or a contract does not hold
  2  usage error, unreadable input, nothing that emits light, a file that cannot
     be written
  3  stopped: what was written, if anything, says that it is incomplete
  4  refused: no surface, faces would be lost, or every filter would make it
     worse; nothing was written)";

Stop usage_error(std::string_view program, std::string_view what) {
  return {kUsage, {}, fmt::format("{0}: {1}\n{0}: --help shows the options\n", program, what)};
}

std::string fault_of(const CLI::App& app, const CLI::ParseError& error) {
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with("-") || word == "-") continue;
    std::vector<std::string_view> names;
    std::vector<std::string> storage;
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) storage.push_back("--" + name);
    }
    names.assign(storage.begin(), storage.end());
    return fmt::format("unknown option {}{}", word, did_you_mean(nearest(word, names)));
  }
  return error.what();
}

/// Nothing where the command line could be taken apart.
std::optional<Stop> parse(CLI::App& app, std::span<const std::string> args) {
  std::vector<std::string> reversed(args.rbegin(), args.rend());
  try {
    app.parse(std::move(reversed));
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) {
      return usage_error(app.get_name(), fault_of(app, error));
    }
    std::ostringstream out;
    app.exit(error, out, out);
    return Stop{kClean, out.str(), {}};
  }
}

void prepare(CLI::App& app, const char* footer) {
  app.get_formatter()->column_width(30);
  app.set_version_flag("--version", fmt::format("{} {}", app.get_name(), report::tool_version()),
                       "Print the version and leave");
  app.footer(footer);
}

void add_model_options(CLI::App& app, ModelWords& words) {
  app.add_option("--tolerance", words.tolerance, "0.5mm, 0.5 (file units), 1e-5d (diagonals), auto")
      ->type_name("LENGTH")
      ->group("Model");
  app.add_option("--units", words.units, "Unit of the file: m, cm, mm, in, ft")->type_name("UNIT")->group("Model");
  app.add_option("-j,--jobs", words.jobs, "Threads; all by default")->type_name("N")->group("Running");
}

void add_list(CLI::App& app, const char* name, std::vector<std::string>& into, const char* what) {
  app.add_option(name, into, what)->delimiter(',')->allow_extra_args(false)->type_name("RULES")->group("Rules");
}

void add_rule_options(CLI::App& app, LintCommand& command, LintWords& words) {
  add_list(app, "--select", command.select, "Check these only: RL201, RL2, t-vertex, ALL");
  add_list(app, "--ignore", command.ignore, "Leave these out");
  app.add_option("--stage", words.stage, "model (default), preprocess, solve, display")
      ->type_name("STAGE")
      ->group("Rules");
  app.add_option("--fail-on", words.fail_on, "error (default), warning, note, never")
      ->type_name("SEVERITY")
      ->group("Rules");
}

void add_report_options(CLI::App& app, LintCommand& command, LintWords& words) {
  app.add_option("--format", words.format, "text (default), json")->type_name("FORMAT")->group("Report");
  app.add_option("--report", words.reports, "Also write one to a file: text, json, leak-line")
      ->allow_extra_args(false)
      ->type_name("FORMAT=PATH")
      ->group("Report");
  app.add_flag_callback(
         "--no-group", [&command] { command.group = false; }, "One finding for every place")
      ->group("Report");
  app.add_option("--max-issues", words.max_issues, "json: findings of a rule; 100, 0 for all")
      ->type_name("N")
      ->group("Report");
  app.add_option("--max-findings", words.max_findings, "text: findings of a rule; 10, 0 for all")
      ->type_name("N")
      ->group("Report");
  app.add_option("--color", words.color, "auto (default), always, never")->type_name("WHEN")->group("Report");
  app.add_flag("--timings", command.timings, "Seconds for each step, in json")->group("Report");
  app.add_flag("-q,--quiet", command.quiet, "Nothing on standard output")->group("Report");
}

std::string read(const LintWords& words, LintCommand& command) {
  if (command.paths.empty()) return "name a model file or a folder";
  std::string fault = read_lint_words(words, command);
  return fault.empty() ? choose_rules(command) : fault;
}

}  // namespace

std::variant<LintCommand, RuleCommand, Stop> parse_radlint(std::span<const std::string> args) {
  CLI::App app("Judges polygon models for radiosity.", "radlint");
  LintCommand command;
  LintWords words;
  prepare(app, kRadlintFooter);
  app.add_option("paths", command.paths, "Model files, or folders to search")->type_name("PATH");
  add_rule_options(app, command, words);
  add_model_options(app, words.model);
  app.add_option("--up", words.model.up, "Up axis of the file: y, z")->type_name("AXIS")->group("Model");
  add_report_options(app, command, words);

  RuleCommand rule_command;
  std::string rule_format;
  CLI::App* rule = app.add_subcommand("rule", "Explain a rule");
  rule->add_option("id", rule_command.id, "RL201 or t-vertex")->required()->type_name("RULE");
  CLI::App* rules = app.add_subcommand("rules", "List all rules");
  for (CLI::App* subcommand : {rule, rules}) {
    subcommand->add_option("--format", rule_format, "text (default), json, markdown")->type_name("FORMAT");
  }

  if (auto stop = parse(app, args)) return *stop;
  if (rule->parsed() || rules->parsed()) {
    const std::string fault = read_rule_format(rule_format.empty() ? words.format : rule_format, rule_command.format);
    if (!fault.empty()) return usage_error("radlint", fault);
    return rule_command;
  }
  const std::string fault = read(words, command);
  if (!fault.empty()) return usage_error("radlint", fault);
  return command;
}

namespace {

void add_coplanar_options(CLI::App& app, FixCommand& command, FixWords& words) {
  app.add_option("--coplanar-policy", words.coplanar_policy, "paper, area, priority, keep-first, keep-last")
      ->type_name("POLICY")
      ->group("Faces that overlap in a plane");
  app.add_option("--priority", command.coplanar.priority, "Material or object to be seen first; repeatable")
      ->allow_extra_args(false)
      ->type_name("GLOB")
      ->group("Faces that overlap in a plane");
  app.add_flag_callback(
         "--no-emitter-priority", [&command] { command.coplanar.emitter_priority = false; },
         "Lights give way like other faces")
      ->group("Faces that overlap in a plane");
}

CLI::Option* add_names(CLI::App& app, const char* name, std::vector<std::string>& into, const char* what) {
  return app.add_option(name, into, what)->delimiter(',')->allow_extra_args(false);
}

void add_stage_options(CLI::App& app, FixWords& words) {
  constexpr const char* kGroup = "Stages: grouper, isect, coplanar, orient, pmesh, emesh, solve, bake";
  app.add_flag("--mesh", words.mesh, "Go on to patches and elements")->group(kGroup);
  app.add_flag("--solve", words.solve, "Go on to a radiosity solution")->group(kGroup);
  app.add_option("--until", words.until, "Stop after this one")->type_name("STAGE")->group(kGroup);
  add_names(app, "--only", words.only, "Run these alone")->type_name("STAGES")->group(kGroup);
  add_names(app, "--skip", words.skip, "Leave these out; repair: the first four")->type_name("STAGES")->group(kGroup);
}

void add_repair_options(CLI::App& app, FixCommand& command, FixWords& words) {
  constexpr const char* kGroup = "Repair";
  add_names(app, "--fix-only", words.fix_only, "Cure these alone: RL110, t-vertex")->type_name("RULES")->group(kGroup);
  app.add_flag("--unsafe-fixes", command.unsafe_fixes, "Leave out faces that cannot be kept")->group(kGroup);
  app.add_flag("--check-contracts", command.check_contracts, "Judge between the stages; exit 1 where one fails")
      ->group(kGroup);
}

void add_light_options(CLI::App& app, FixWords& words) {
  constexpr const char* kGroup = "Mesh and light";
  app.add_option("--patch-size", words.patch_size, "Longest patch edge, file units (by area)")
      ->type_name("LENGTH")
      ->group(kGroup);
  app.add_option("--element-size", words.element_size, "Longest element edge (a quarter of the patch size)")
      ->type_name("LENGTH")
      ->group(kGroup);
  app.add_option("--exposure", words.exposure, "Display colour per W/m2 (automatic)")
      ->type_name("NUMBER")
      ->group(kGroup);
}

void add_output_options(CLI::App& app, FixCommand& command, FixWords& words) {
  constexpr const char* kGroup = "Output and reports";
  app.add_option("-o,--output", command.output, "A name in one of the formats, or -")->type_name("OUT")->group(kGroup);
  app.add_flag("--in-place", command.in_place, "Write to IN, which is kept as IN.orig")->group(kGroup);
  app.add_flag("--dry-run", command.dry_run, "Write no model, say what would be done")->group(kGroup);
  app.add_flag("--diff", command.diff, "Say what changed, and where")->group(kGroup);
  app.add_option("--report", words.report, "Write a report to a file")->type_name("json=PATH")->group(kGroup);
  app.add_option("--annotate", command.annotate, "Write a model coloured by what was done")
      ->type_name("GLB")
      ->group(kGroup);
  app.add_option("--preview", command.preview, "Write a picture as well")->type_name("PNG")->group(kGroup);
  app.add_flag("--timings", command.timings, "Put seconds for each stage into the report")->group(kGroup);
}

void add_facade_options(CLI::App& app, FixCommand& command) {
  app.add_option("--two-sided", command.two_sided, "Double faces of objects or materials, repeatable")
      ->allow_extra_args(false)
      ->type_name("GLOB")
      ->group("Unsafe");
  app.add_flag("--cap-planar", command.cap_planar, "Close flat openings")->group("Unsafe");
}

}  // namespace

std::variant<FixCommand, Stop> parse_radfix(std::span<const std::string> args) {
  CLI::App app("Repairs polygon models, meshes them, solves for light; judges what it wrote.", "radfix");
  FixCommand command;
  ModelWords words;
  prepare(app, kRadfixFooter);
  app.add_option("input", command.input, "Model file; - or none for standard input")->type_name("IN");
  FixWords fix;
  add_stage_options(app, fix);
  add_repair_options(app, command, fix);
  add_coplanar_options(app, command, fix);
  add_light_options(app, fix);
  add_output_options(app, command, fix);
  add_facade_options(app, command);
  add_model_options(app, words);
  if (auto stop = parse(app, args)) return *stop;
  std::string fault = read_model_words(words, command.model);
  if (fault.empty()) fault = read_fix_words(fix, command);
  if (!fault.empty()) return usage_error("radfix", fault);
  return command;
}

}  // namespace rad::cli
