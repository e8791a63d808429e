#include "cli/option_parser.h"

#include <fmt/format.h>

#include <sstream>

#include "cli/completion.h"
#include "cli/exit_code.h"
#include "cli/nearest.h"
#include "readers/components.h"

namespace rad::cli {

Stop usage_error(std::string_view program, std::string_view what) {
  return {kUsage, {}, fmt::format("{0}: {1}\n{0}: --help shows the options\n", program, what)};
}

namespace {

// With the components that a build or a machine may be without.
std::string version_text(const std::string& program) {
  std::string text = fmt::format("{} {}", program, report::tool_version());
  for (const readers::Component& component : readers::components()) {
    text += component.version.empty()
                ? fmt::format("\n  without {} ({})", component.name, component.formats)
                : fmt::format("\n  with {} {} ({})", component.name, component.version, component.formats);
  }
  return text;
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

/// Thrown by --completion, as CLI11 does for --version.
struct CompletionAsked : CLI::Success {
  explicit CompletionAsked(std::string name) : shell(std::move(name)) {}
  std::string shell;
};

}  // namespace

std::optional<Stop> parse(CLI::App& app, std::span<const std::string> args) {
  std::vector<std::string> reversed(args.rbegin(), args.rend());
  try {
    app.parse(std::move(reversed));
    return std::nullopt;
  } catch (const CompletionAsked& asked) {
    const auto script = completion_script(completed(app), asked.shell);
    if (!script) return usage_error(app.get_name(), fmt::format("--completion: '{}' is no shell", asked.shell));
    return Stop{kClean, *script, {}};
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
  app.set_version_flag("--version", version_text(app.get_name()), "Print the version and leave");
  app.add_option_function<std::string>(
         "--completion", [](const std::string& shell) { throw CompletionAsked(shell); },
         "Print completion for a shell: bash, zsh, fish")
      ->type_name("SHELL");
  app.footer(footer);
}

void add_model_options(CLI::App& app, ModelWords& words) {
  app.add_option("--tolerance", words.tolerance, "0.5mm, 0.5 (file units), 1e-5d (diagonals), auto")
      ->type_name("LENGTH")
      ->group("Model");
  app.add_option("--units", words.units, "Unit of the file: m, cm, mm, in, ft")->type_name("UNIT")->group("Model");
  app.add_option("--lod", words.level_of_detail, "CityJSON: level of detail, as 2.2 (the finest)")
      ->type_name("LOD")
      ->group("Model");
  app.add_flag("--allow-commands", words.allow_commands, "Radiance: run !command lines")->group("Model");
  app.add_option("-j,--jobs", words.jobs, "Threads; all by default")->type_name("N")->group("Running");
}

void add_config_options(CLI::App& app, LintCommand& command) {
  app.add_option("--config", command.config, "This file instead of the nearest radlint.toml")
      ->type_name("FILE")
      ->group("Configuration");
  app.add_flag("--isolated", command.isolated, "Heed no radlint.toml")->group("Configuration");
}

}  // namespace rad::cli
