// Completion of command lines by a shell, made of the options themselves.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rad::cli {

/// An option as a shell completes it.
struct CompletedOption {
  std::vector<std::string> names;    ///< with dashes
  std::string what;                  ///< one line
  std::string value;                 ///< name of its value; empty for a flag
  std::vector<std::string> choices;  ///< of the value; empty where it is free, such as a path
};

struct CompletedCommand {
  std::string name;
  std::string what;
  std::vector<CompletedOption> options;
  bool takes_rules = false;  ///< rather than files
};

struct CompletedProgram {
  CompletedCommand main;
  std::vector<CompletedCommand> subcommands;
  std::vector<std::string> rules;  ///< ids and aliases
};

CompletedProgram completed(const CLI::App& app);

/// The words that a description lists, "model (default), solve" or "Unit of the file: m, cm"; none where it is prose.
std::vector<std::string> listed_choices(std::string_view description);

/// A script for bash, zsh or fish; nothing for another shell.
std::optional<std::string> completion_script(const CompletedProgram& program, std::string_view shell);

}  // namespace rad::cli
