// What the command lines of both programs have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/option_values.h"
#include "cli/options.h"

namespace rad::cli {

/// A usage error in words.
Stop usage_error(std::string_view program, std::string_view what);

/// Nothing where the command line could be taken apart; else help, version or a usage error.
std::optional<Stop> parse(CLI::App& app, std::span<const std::string> args);

/// Sets up help, version and the text below the options.
void prepare(CLI::App& app, const char* footer);

/// --tolerance, --units and --jobs.
void add_model_options(CLI::App& app, ModelWords& words);

/// --config and --isolated.
void add_config_options(CLI::App& app, LintCommand& command);

}  // namespace rad::cli
