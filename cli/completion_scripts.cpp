#include "cli/completion_scripts.h"

#include <fmt/format.h>

namespace rad::cli {
namespace {

std::string joined(const std::vector<std::string>& words, std::string_view between = " ") {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

/// What the value of an option is completed with: its choices, those of rules, those of FORMAT=PATH with the sign.
std::vector<std::string> values_of(const CompletedOption& option, const CompletedProgram& program) {
  if (option.value == "RULES") return program.rules;
  std::vector<std::string> values = option.choices;
  if (option.value.ends_with("=PATH")) {
    if (values.empty()) values.push_back(option.value.substr(0, option.value.find('=')));
    for (std::string& value : values) value += '=';
  }
  return values;
}

std::string option_words(const CompletedCommand& command) {
  std::string text;
  for (const CompletedOption& option : command.options) text += (text.empty() ? "" : " ") + joined(option.names);
  return text;
}

std::string without_quotes(std::string text, std::string_view quotes) {
  std::erase_if(text, [&](char c) { return quotes.find(c) != std::string_view::npos; });
  return text;
}

std::string bash_values(const CompletedProgram& program) {
  std::string out;
  const auto add = [&](const CompletedCommand& command) {
    for (const CompletedOption& option : command.options) {
      if (option.value.empty()) continue;
      const std::vector<std::string> values = values_of(option, program);
      const std::string reply = values.empty() ? "compgen -f" : fmt::format("compgen -W '{}'", joined(values));
      out += fmt::format("    {}) COMPREPLY=($({} -- \"$word\")); return ;;\n", joined(option.names, "|"), reply);
    }
  };
  add(program.main);
  for (const CompletedCommand& command : program.subcommands) add(command);
  return out;
}

}  // namespace

std::string bash_completion(const CompletedProgram& program) {
  const std::string& name = program.main.name;
  std::string out = fmt::format(R"(# bash completion of {0}; made by {0} --completion bash
_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
  # --stage=solve comes as three words.
  if [[ $word == = ]]; then word=; elif [[ $before == = ]]; then before=${{COMP_WORDS[COMP_CWORD-2]}}; fi
  compopt -o filenames
  [[ $before == --report ]] && compopt -o nospace
  case $before in
{1}  esac
  local options='{2}' rules='{3}'
)",
                                name, bash_values(program), option_words(program.main), joined(program.rules));
  std::vector<std::string> commands;
  if (!program.subcommands.empty()) out += "  case ${COMP_WORDS[1]} in\n";
  for (const CompletedCommand& command : program.subcommands) {
    commands.push_back(command.name);
    const std::string reply = command.takes_rules ? "compgen -W \"$rules\"" : "compgen -f";
    out += fmt::format(
        "    {}) if [[ $word == -* ]]; then COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n"
        "      else COMPREPLY=($({} -- \"$word\")); fi; return ;;\n",
        command.name, option_words(command), reply);
  }
  if (!program.subcommands.empty()) out += "  esac\n";
  out += "  if [[ $word == -* ]]; then COMPREPLY=($(compgen -W \"$options\" -- \"$word\")); return; fi\n";
  out += "  COMPREPLY=($(compgen -f -- \"$word\"))\n";
  if (!commands.empty()) {
    out += fmt::format("  (( COMP_CWORD == 1 )) && COMPREPLY+=($(compgen -W '{}' -- \"$word\"))\n", joined(commands));
  }
  return out + fmt::format("  return 0\n}}\ncomplete -F _{0} {0}\n", name);
}

namespace {

// In [brackets] of a specification that stands in single quotes.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : without_quotes(text, "'\"`")) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_option(const CompletedOption& option, const CompletedProgram& program) {
  const std::vector<std::string> values = values_of(option, program);
  std::string action;
  if (!option.value.empty()) {
    const bool report = option.value.ends_with("=PATH");
    action = fmt::format(":{}:{}", zsh_text(option.value),
                         values.empty() ? "_files"
                         : report       ? fmt::format("{{compadd -S \"\" -- {}}}", joined(values))
                                        : fmt::format("({})", joined(values)));
  }
  std::string out;
  for (const std::string& name : option.names) {
    const std::string_view sign = option.value.empty() ? "" : name.starts_with("--") ? "=" : "+";
    out += fmt::format("    '*{}{}[{}]{}'\n", name, sign, zsh_text(option.what), action);
  }
  return out;
}

std::string zsh_arguments(const CompletedCommand& command, const CompletedProgram& program) {
  std::string out = "  local -a arguments=(\n";
  for (const CompletedOption& option : command.options) out += zsh_option(option, program);
  out += command.takes_rules ? fmt::format("    '1:rule:({})'\n", joined(program.rules)) : "    '*:file:_files'\n";
  return out + "  )\n  _arguments -s -S $arguments\n";
}

}  // namespace

std::string zsh_completion(const CompletedProgram& program) {
  const std::string& name = program.main.name;
  std::string out = fmt::format("#compdef {0}\n# zsh completion of {0}; made by {0} --completion zsh\n\n", name);
  for (const CompletedCommand& command : program.subcommands) {
    out += fmt::format("_{}_{}() {{\n{}}}\n\n", name, command.name, zsh_arguments(command, program));
  }
  out += fmt::format("_{}() {{\n", name);
  if (!program.subcommands.empty()) {
    out += "  case $words[2] in\n";
    for (const CompletedCommand& command : program.subcommands) {
      out += fmt::format("    {1}) shift words; (( CURRENT-- )); _{0}_{1}; return ;;\n", name, command.name);
    }
    out += "  esac\n  if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then\n    local -a commands=(\n";
    for (const CompletedCommand& command : program.subcommands) {
      out += fmt::format("      '{}:{}'\n", command.name, zsh_text(command.what));
    }
    out += "    )\n    _describe command commands\n  fi\n";
  }
  return out + fmt::format("{}}}\n\n_{} \"$@\"\n", zsh_arguments(program.main, program), name);
}

std::string fish_completion(const CompletedProgram& program) {
  const std::string& name = program.main.name;
  std::string out = fmt::format("# fish completion of {0}; made by {0} --completion fish\n", name);
  const auto text = [](const std::string& what) { return without_quotes(what, "'\\"); };
  const auto add = [&](const CompletedCommand& command, const std::string& condition) {
    for (const CompletedOption& option : command.options) {
      out += fmt::format("complete -c {}{}", name, condition);
      for (const std::string& dashed : option.names) {
        out += dashed.starts_with("--") ? " -l " + dashed.substr(2) : " -s " + dashed.substr(1);
      }
      const std::vector<std::string> values = values_of(option, program);
      if (!option.value.empty()) out += values.empty() ? " -r" : fmt::format(" -x -a '{}'", joined(values));
      out += fmt::format(" -d '{}'\n", text(option.what));
    }
    if (command.takes_rules) {
      out += fmt::format("complete -c {}{} -f -a '{}'\n", name, condition, joined(program.rules));
    }
  };
  add(program.main, "");
  for (const CompletedCommand& command : program.subcommands) {
    out +=
        fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d '{}'\n", name, command.name, text(command.what));
    add(command, fmt::format(" -n '__fish_seen_subcommand_from {}'", command.name));
  }
  return out;
}

}  // namespace rad::cli
