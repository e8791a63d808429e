// radlint's command line.
#include "cli/annotated_scene.h"
#include "cli/baseline.h"
#include "cli/option_parser.h"
#include "cli/options.h"

namespace rad::cli {

namespace {

constexpr const char* kRadlintFooter = R"(Examples:
  radlint room.obj                          judge a model
  radlint models/ --report json=lint.json   judge a folder, keep a report
  radlint room.obj --report html=room.html  see the faults in a browser
  radlint --stage solve --select RL2 a.glb  what a solver asks of the mesh
  radlint diff old.glb new.glb              what is new, what is fixed
  radlint rule RL201                        what a rule means
  radlint config room.obj                   what is in force, and from where
  radlint merge part*.json --format text    one report of the shards of a run

Report formats:
  text, concise, json, jsonl, sarif, junit, github, markdown, html, csv,
  leak-line

Exit codes:
  0  nothing at or above --fail-on
  1  findings at or above --fail-on
  2  usage error, a configuration that is not understood, a path that does not
     exist, a report that cannot be written
  3  judged in part only: a limit was hit, or it was interrupted)";

void add_list(CLI::App& app, const char* name, std::vector<std::string>& into, const char* what) {
  app.add_option(name, into, what)->delimiter(',')->allow_extra_args(false)->type_name("RULES")->group("Rules");
}

void add_rule_options(CLI::App& app, LintCommand& command, LintWords& words) {
  add_list(app, "--select", command.select, "Check these only: RL201, RL2, t-vertex, ALL");
  add_list(app, "--ignore", command.ignore, "Leave these out");
  add_list(app, "--extend-select", command.extend_select, "Check these too");
  add_list(app, "--extend-ignore", command.extend_ignore, "Leave these out too");
  app.add_option("--severity", command.severities, "RL240=note: error, warning, note, off")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("RULE=SEVERITY")
      ->group("Rules");
  app.add_option("--stage", words.stage, "model (default), preprocess, solve, display")
      ->type_name("STAGE")
      ->group("Rules");
  app.add_option("--fail-on", words.fail_on, "error (default), warning, note, never")
      ->type_name("SEVERITY")
      ->group("Rules");
}

void add_report_options(CLI::App& app, LintCommand& command, LintWords& words) {
  app.add_option("--format", words.format, "Of standard output; text by default")->type_name("FORMAT")->group("Report");
  app.add_option("--report", words.reports, "Also write a report to a file; repeatable")
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
  app.add_option("--annotate", command.annotate, "Write the model with the faces found in colour")
      ->type_name("GLB")
      ->group("Report");
  app.add_flag("--timings", command.timings, "Seconds for each step, in json")->group("Report");
  app.add_flag("-q,--quiet", command.quiet, "Nothing on standard output")->group("Report");
}

void add_run_options(CLI::App& app, LintCommand& command, LintWords& words) {
  app.add_option("--exclude", command.exclude, "Leave out of folders: legacy, 'site/**'")
      ->allow_extra_args(false)
      ->type_name("GLOB")
      ->group("Running");
  app.add_option("--time-limit", words.time_limit, "Most seconds for a file")->type_name("SECONDS")->group("Running");
  app.add_option("--memory-limit", words.memory_limit, "Most memory for a file: 512M, 4G")
      ->type_name("SIZE")
      ->group("Running");
  app.add_option("--cache", command.cache, "Keep results here (folders: in the user's cache)")
      ->type_name("FOLDER")
      ->group("Running");
  app.add_flag("--no-cache", command.no_cache, "Judge everything anew")->group("Running");
  app.add_option("--shard", words.shard, "The i-th of n parts of the files; see merge")
      ->type_name("I/N")
      ->group("Running");
}

void add_baseline_options(CLI::App& app, LintCommand& command) {
  constexpr const char* kGroup = "Baseline";
  BaselineChoice& choice = command.baseline;
  app.add_option("--baseline", choice.path, "Leave out what this report knows")->type_name("FILE")->group(kGroup);
  app.add_option("--write-baseline", choice.write, "Take all that is found as known")->type_name("FILE")->group(kGroup);
  app.add_flag("--prune-baseline", choice.prune, "Take out of it what is not there any more")->group(kGroup);
  app.add_flag("--strict-baseline", choice.strict, "What is not there any more is an error")->group(kGroup);
}

// Takes the options of radlint as well: how models are judged, and what the comparison is written in.
const CLI::App* add_diff(CLI::App& app, DiffCommand& command) {
  CLI::App* diff = app.add_subcommand("diff", "New, fixed, changed between reports or models");
  diff->fallthrough();
  diff->add_option("old", command.old, "Report (.json, .jsonl), model or folder")->required()->type_name("OLD");
  diff->add_option("new", command.now, "The same, as it is now")->required()->type_name("NEW");
  diff->footer(
      "Takes the options of radlint. Formats: text, json, markdown, html.\nExit code 1 only where something is new or "
      "worse.");
  return diff;
}

std::string read_diff(const LintWords& words, DiffCommand& command) {
  std::string fault = read_diff_words(words, command);
  return fault.empty() ? read_settings(command.lint) : fault;
}

std::string read(const LintWords& words, LintCommand& command) {
  if (command.paths.empty()) return "name a model file or a folder";
  std::string fault = read_lint_words(words, command);
  if (fault.empty()) fault = baseline_fault(command.baseline);
  if (fault.empty()) fault = annotation_problem(command.annotate);
  return fault.empty() ? read_settings(command) : fault;
}

using Parsed = std::variant<LintCommand, RuleCommand, DiffCommand, MergeCommand, ConfigCommand, Stop>;

Parsed read_config(LintWords words, LintCommand how) {
  ConfigCommand command;
  if (how.paths.size() > 1) return usage_error("radlint", "config: name one model or folder, or none");
  std::string fault = read_config_format(words.format, command.format);
  words.format.clear();
  if (fault.empty()) fault = read_lint_words(words, how);
  if (fault.empty()) fault = read_settings(how);
  if (!fault.empty()) return usage_error("radlint", fault);
  command.how = std::move(how);
  return command;
}

}  // namespace

std::variant<LintCommand, RuleCommand, DiffCommand, MergeCommand, ConfigCommand, Stop> parse_radlint(
    std::span<const std::string> args) {
  CLI::App app("Judges polygon models for radiosity.", "radlint");
  LintCommand command;
  LintWords words;
  prepare(app, kRadlintFooter);
  app.add_option("paths", command.paths, "Model files, or folders to search")->type_name("PATH");
  add_rule_options(app, command, words);
  add_config_options(app, command);
  add_model_options(app, words.model);
  app.add_option("--up", words.model.up, "Up axis of the file: y, z")->type_name("AXIS")->group("Model");
  add_run_options(app, command, words);
  add_report_options(app, command, words);
  add_baseline_options(app, command);

  RuleCommand rule_command;
  std::string rule_format;
  CLI::App* rule = app.add_subcommand("rule", "Explain a rule");
  rule->add_option("id", rule_command.id, "RL201 or t-vertex")->required()->type_name("RULE");
  CLI::App* rules = app.add_subcommand("rules", "List all rules");
  for (CLI::App* subcommand : {rule, rules}) {
    subcommand->add_option("--format", rule_format, "text (default), json, markdown")->type_name("FORMAT");
  }

  CLI::App* merge = app.add_subcommand("merge", "Make one report of several")->fallthrough();
  const CLI::App* config = app.add_subcommand("config", "What is in force for a model, and from where")->fallthrough();
  DiffCommand diff_command;
  const CLI::App* diff = add_diff(app, diff_command);

  if (auto stop = parse(app, args)) return *stop;
  if (diff->parsed()) {
    diff_command.lint = command;
    const std::string fault = read_diff(words, diff_command);
    if (!fault.empty()) return usage_error("radlint diff", fault);
    return diff_command;
  }
  if (rule->parsed() || rules->parsed()) {
    const std::string fault = read_rule_format(rule_format.empty() ? words.format : rule_format, rule_command.format);
    if (!fault.empty()) return usage_error("radlint", fault);
    return rule_command;
  }
  if (merge->parsed()) {
    if (command.paths.empty()) return usage_error("radlint", "name JSON reports to merge");
    const std::string fault = read_lint_words(words, command);
    if (!fault.empty()) return usage_error("radlint", fault);
    return MergeCommand{std::move(command)};
  }
  if (config->parsed()) return read_config(words, std::move(command));
  const std::string fault = read(words, command);
  if (!fault.empty()) return usage_error("radlint", fault);
  return command;
}

}  // namespace rad::cli
