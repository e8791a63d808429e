// What can be compared between two judgements of a model, and what changed.
#pragma once

#include <string>

#include "report/matching.h"
#include "report/report.h"

namespace rad::report {

/// How a fault that both sides have differs.
struct FaultChange {
  std::string words;   ///< "2 places before, 5 now"; empty where nothing changed
  bool worse = false;  ///< a higher severity or more violations
};

/// Two judgements of one model, perhaps in two formats: what one of them cannot hold says nothing about the model.
class Comparison {
 public:
  Comparison(const InputReport& old, const InputReport& now);

  [[nodiscard]] Matching matching() const;

  /// Whether a finding that one side alone has may come from what the formats hold: triangles instead of polygons, no
  /// names of objects and materials, no unit.
  [[nodiscard]] bool is_of_format(const scene::Finding& finding) const;

  [[nodiscard]] FaultChange change_of(const Match& match) const;

  /// T, file units, the larger of both sides.
  [[nodiscard]] double tolerance() const { return tolerance_; }

 private:
  const InputReport& old_;
  const InputReport& now_;
  bool same_kind_;   ///< both hold polygons, or both triangles only
  bool names_lost_;  ///< one side knows objects and materials, the other does not
  double tolerance_ = 0;
};

}  // namespace rad::report
