// What a run of radlint found, ready to be written as text or JSON.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/lattice.h"
#include "scene/scene.h"
#include "validate/lint.h"
#include "validate/stage.h"

namespace rad::report::html {
struct ModelView;
}

namespace rad::report {

/// Version of the JSON reports' shape, semantic versioning.
inline constexpr std::string_view kSchemaVersion = "1.3.0";

/// Version of the tools, "0.1.0".
std::string_view tool_version();

/// Whether a unit or an axis comes from the file, from the command line, or is not known.
enum class ValueSource : std::uint8_t { Unknown, Declared, Given };

/// Findings of one rule that a report read back only counts.
struct Unlisted {
  std::string_view rule;
  std::string_view requirement;
  scene::Severity severity = scene::Severity::Note;
  std::uint64_t places = 0;    ///< violations
  std::uint64_t findings = 0;  ///< clusters of violations
};

/// One judged file.
struct InputReport {
  std::string path;           ///< as the user gave it
  std::string configuration;  ///< path of the radlint.toml that it was judged by; empty for none
  std::string format;         ///< "obj"; empty where the file could not be told
  std::uint64_t bytes = 0;
  std::optional<double> metres_per_unit;
  ValueSource units_source = ValueSource::Unknown;
  scene::UpAxis up = scene::UpAxis::Unknown;
  ValueSource up_source = ValueSource::Unknown;
  geom::Box box;      ///< file units, of the finite vertices that faces use
  bool read = false;  ///< false: nothing of the file could be read
  validate::LintResult result;
  std::vector<Unlisted> unlisted;               ///< of an input that was read from a report: what that did not list
  std::vector<scene::Finding> known;            ///< left out of the result, since a baseline has them; in its order
  std::shared_ptr<const html::ModelView> view;  ///< what an HTML report shows; null where none was asked for
};

/// The least severity that makes a run fail.
enum class FailOn : std::uint8_t { Error, Warning, Note, Never };

/// Part of a run that was divided: which of all its files are here.
struct Shard {
  std::size_t index = 1;  ///< 1 to count
  std::size_t count = 1;
  std::size_t files = 0;               ///< of the whole run
  std::vector<std::size_t> positions;  ///< in the whole run, of each input; ascending
  friend bool operator==(const Shard&, const Shard&) = default;
};

struct Report {
  std::string tool = "radlint";
  validate::Stage stage = validate::Stage::Model;
  FailOn fail_on = FailOn::Error;
  std::vector<std::string> select;  ///< as given, in order
  std::vector<std::string> ignore;
  std::size_t max_issues = 100;  ///< findings listed in JSON for each rule and input; 0 lists all
  std::vector<InputReport> inputs;
  std::optional<Shard> shard;  ///< nothing for a whole run
};

/// Numbers of findings by severity.
struct Counts {
  std::uint64_t errors = 0;
  std::uint64_t warnings = 0;
  std::uint64_t notes = 0;

  void add(scene::Severity severity, std::uint64_t findings = 1);
  Counts& operator+=(const Counts& other);
  friend constexpr bool operator==(const Counts&, const Counts&) = default;
};

Counts counts(const InputReport& input);
Counts counts(const Report& report);

/// Findings that a baseline has and that count for nothing else.
std::uint64_t known_findings(const Report& report);

/// Findings that their authors asked not to be told of; they count for nothing else.
std::uint64_t suppressed_findings(const InputReport& input);
std::uint64_t suppressed_findings(const Report& report);

/// Whether a run with these findings fails under `fail_on`.
bool reaches(const Counts& counts, FailOn fail_on);

/// Totals of one rule over all inputs.
struct RuleTotal {
  std::string_view rule;
  scene::Severity severity = scene::Severity::Note;  ///< the highest that occurs
  std::uint64_t places = 0;                          ///< violations
  std::uint64_t findings = 0;                        ///< clusters of violations
  bool truncated = false;                            ///< more findings than `max_issues` in some input
};

/// What a list of at most `max_issues` findings of each rule (0: all) leaves out of an input, by rule and severity.
std::vector<Unlisted> unlisted_findings(const InputReport& input, std::size_t max_issues);

/// Rules that occur, by id.
std::vector<RuleTotal> rule_totals(const Report& report);

/// Rules that ran on some input, in the order of all rules.
std::vector<const validate::Rule*> checked_rules(const Report& report);

std::string_view name(FailOn fail_on);
std::string_view name(ValueSource source);
std::string_view name(scene::UpAxis up);  ///< "y", "z"; empty where unknown

}  // namespace rad::report
