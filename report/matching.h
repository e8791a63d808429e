// Which finding of one judgement is which of another: the places decide, never lines or order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "report/report.h"

namespace rad::report {

/// Findings that are the same fault. Mostly one of each; several where a format that knows no objects (or materials)
/// made one finding of many, or many of one.
struct Match {
  std::vector<const scene::Finding*> old;  ///< never empty
  std::vector<const scene::Finding*> now;  ///< never empty
};

struct Matching {
  std::vector<Match> matches;
  std::vector<const scene::Finding*> only_old;
  std::vector<const scene::Finding*> only_now;
};

struct MatchOptions {
  double tolerance = 0;  ///< T, file units, the larger of both sides
  /// One side knows no objects and materials: rules that only these tell apart (RL220 and RL221, RL222 and RL114) count
  /// as one.
  bool names_lost = false;
  bool regrouped = false;  ///< one side holds triangles only, and groups by them
};

/// Findings of one model judged twice. In this order, each among what is left, and always within a rule:
///   1. equal fingerprints; of several equal ones the nearest pairs first;
///   2. equal participants, and a place within 64 T, in the model or relative to the object;
///   3. a place within 16 T and as many violations, whoever takes part;
///   4. groups of findings within equal bounds, with as many violations where both sides group alike;
///   5. a place within 16 T; equal participants, and bounds that overlap by half: a cluster that grew or shrank;
///   6. findings without a place with equal participants;
///   7. the only findings with these participants, where both stand for several violations or for the whole model;
///   8. where formats group differently, what lies in the bounds of a match with these participants joins it.
/// The result points into `old` and `now`, in the order of these.
Matching match_findings(std::span<const scene::Finding> old, std::span<const scene::Finding> now,
                        const MatchOptions& options);

}  // namespace rad::report
