// Running one rule over a context: what it finds, what of that is silenced, and what either weighs.
#pragma once

#include "validate/context.h"
#include "validate/grouping.h"
#include "validate/waivers.h"

namespace rad::validate {

/// Runs the rules of a judgement one by one and collects their findings.
class RuleRun {
 public:
  /// `context` has the thresholds of the options, and other ones while a rule runs where names have others.
  RuleRun(Context& context, const LintOptions& options);

  /// Nothing happens where the stage does not ask for the rule and no severity is given. False then.
  bool run(const Rule& rule);

  /// Moves what was found into `result`, with what is to be said about the waivers.
  void finish(LintResult& result);

 private:
  /// Violations by what they weigh: SIZE_MAX for the usual severity, else the place in named_severities.
  using ByWeight = std::map<std::size_t, Violations>;

  [[nodiscard]] std::optional<Severities> severities_of(const Rule& rule) const;
  [[nodiscard]] std::size_t weight_of(const Rule& rule, const Violation& violation) const;
  void run_check(const Rule& rule, const Severities& severities);
  void report_violations(const Rule& rule, const Severities& severities, const Violations& violations);
  void run_issues(const Rule& rule, const Severities& severities);
  void report(std::vector<scene::Finding> findings);
  void suppress(std::size_t waiver, std::vector<scene::Finding> findings);

  Context& context_;
  const LintOptions& options_;
  Waivers waivers_;
  std::vector<scene::NamedFaces> named_;  ///< per named severity
  std::vector<const Rule*> checked_;
  std::vector<scene::Finding> findings_;
  std::map<std::size_t, std::vector<scene::Finding>> suppressed_;  ///< by waiver
};

}  // namespace rad::validate
