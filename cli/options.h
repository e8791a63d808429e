// The command lines of both programs, taken apart.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "cli/terminal.h"
#include "geom/tolerance.h"
#include "report/report.h"
#include "validate/registry.h"
#include "validate/stage.h"

namespace rad::cli {

enum class Format : unsigned char { Text, Json, Markdown, LeakLine };

/// What a user says about every model of a run; what is left unsaid comes from the file.
struct ModelOptions {
  std::optional<geom::ToleranceRequest> tolerance;
  std::optional<double> metres_per_unit;
  scene::UpAxis up = scene::UpAxis::Unknown;
  std::size_t jobs = 0;  ///< threads; 0: all that the machine has
};

struct FileReport {
  Format format = Format::Json;
  std::string path;
};

struct LintCommand {
  std::vector<std::string> paths;
  Format format = Format::Text;
  std::vector<FileReport> reports;
  std::vector<std::string> select;
  std::vector<std::string> ignore;
  std::vector<const validate::Rule*> rules;  ///< what select and ignore leave; never empty
  validate::Stage stage = validate::Stage::Model;
  report::FailOn fail_on = report::FailOn::Error;
  ModelOptions model;
  bool group = true;
  std::size_t max_issues = 100;
  std::optional<std::size_t> max_findings;
  ColorChoice color = ColorChoice::Auto;
  bool timings = false;
  bool quiet = false;
};

struct RuleCommand {
  std::string id;  ///< id or alias; empty: all rules
  Format format = Format::Text;
};

struct FixCommand {
  std::string input;
  std::string output;
  std::string report;  ///< path of the JSON report; empty for none
  ModelOptions model;
  bool repair = true;
  std::vector<std::string> two_sided;  ///< patterns of objects and materials whose faces are doubled
  bool cap_planar = false;             ///< close flat openings
  bool mesh = false;                   ///< go on to patches and elements
  bool solve = false;                  ///< and to a radiosity solution; implies mesh
  std::optional<double> patch_size;    ///< longest patch edge, file units; nothing: from the area of the model
  std::optional<double> element_size;  ///< longest element edge, file units; nothing: a quarter of the patch size
  std::optional<double> exposure;      ///< of displayed colours, m²/W; nothing: automatic
  std::string preview;                 ///< path of a PNG picture; empty for none
  bool timings = false;
};

/// Nothing more to do: help or version on standard output, or a usage error on standard error.
struct Stop {
  int exit_code = 0;
  std::string out;
  std::string err;
};

/// `args` are without the program's name.
std::variant<LintCommand, RuleCommand, Stop> parse_radlint(std::span<const std::string> args);
std::variant<FixCommand, Stop> parse_radfix(std::span<const std::string> args);

}  // namespace rad::cli
