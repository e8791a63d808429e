// Where which thresholds of a rule hold: faces of some names have others than the rest.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "scene/name_patterns.h"
#include "validate/lint.h"
#include "validate/violation.h"

namespace rad::validate {

class ThresholdZones {
 public:
  ThresholdZones(const Rule& rule, const LintOptions& options, const scene::Scene& scene);

  /// All values that hold for some violation of the rule, those without names first.
  [[nodiscard]] std::span<const ParameterValues> values() const { return values_; }

  /// Which of them hold for this one: those of every entry that speaks of one of its faces, the last of several.
  [[nodiscard]] std::size_t zone_of(const Violation& violation) const;

 private:
  using Entries = std::vector<bool>;  ///< which of entries_ speak of something

  [[nodiscard]] Entries entries_of(const scene::Face& face) const;
  [[nodiscard]] ParameterValues values_under(const Entries& entries) const;
  void find_values();

  const Rule& rule_;
  const LintOptions& options_;
  const scene::Scene& scene_;
  std::vector<const NamedThreshold*> entries_;
  std::vector<scene::NamedFaces> named_;  ///< per entry
  std::vector<ParameterValues> values_;
};

}  // namespace rad::validate
