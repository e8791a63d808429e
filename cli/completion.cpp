#include "cli/completion.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/completion_scripts.h"
#include "report/formats.h"
#include "scene/filter.h"
#include "validate/registry.h"

namespace rad::cli {
namespace {

bool is_word(std::string_view text) {
  const auto in_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  return !text.empty() && std::ranges::all_of(text, in_word);
}

std::vector<std::string> filter_names() {
  std::vector<std::string> names;
  for (const scene::Filter filter : scene::kFilters) names.emplace_back(scene::name(filter));
  return names;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const report::ReportFormat& format : report::report_formats()) names.emplace_back(format.name);
  return names;
}

CompletedOption completed(const CLI::Option& option) {
  CompletedOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  result.what = option.get_description();
  if (option.get_items_expected_max() > 0) {
    result.value = option.get_type_name();
    if (result.value != "RULES") result.choices = listed_choices(result.what);
    if (result.value.starts_with("FORMAT") && result.choices.empty()) result.choices = format_names();
    if (result.value.starts_with("STAGE") && result.choices.empty()) result.choices = filter_names();
  }
  return result;
}

CompletedCommand completed_command(const CLI::App& app) {
  CompletedCommand command{app.get_name(), app.get_description(), {}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) {
      command.takes_rules = command.takes_rules || option->get_type_name() == "RULE";
    } else {
      command.options.push_back(completed(*option));
    }
  }
  return command;
}

}  // namespace

std::vector<std::string> listed_choices(std::string_view description) {
  if (const std::size_t colon = description.find(": "); colon != std::string_view::npos) {
    description.remove_prefix(colon + 2);
  }
  std::vector<std::string> choices;
  while (true) {
    const std::size_t end = description.find(", ");
    std::string_view word = description.substr(0, end);
    if (word.ends_with(" (default)")) word.remove_suffix(std::string_view(" (default)").size());
    if (!is_word(word)) return {};
    choices.emplace_back(word);
    if (end == std::string_view::npos) break;
    description.remove_prefix(end + 2);
  }
  return choices.size() > 1 ? choices : std::vector<std::string>{};
}

CompletedProgram completed(const CLI::App& app) {
  CompletedProgram program{completed_command(app), {}, {}};
  const auto all = [](const CLI::App*) { return true; };
  for (const CLI::App* subcommand : app.get_subcommands(all)) {
    program.subcommands.push_back(completed_command(*subcommand));
  }
  for (const validate::Rule* rule : validate::all_rules()) {
    program.rules.emplace_back(rule->id);
    program.rules.emplace_back(rule->alias);
  }
  return program;
}

std::optional<std::string> completion_script(const CompletedProgram& program, std::string_view shell) {
  if (shell == "bash") return bash_completion(program);
  if (shell == "zsh") return zsh_completion(program);
  if (shell == "fish") return fish_completion(program);
  return std::nullopt;
}

}  // namespace rad::cli
