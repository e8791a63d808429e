// Everything that must hold of the repair of a scene, asked of the result and of the file that is written of it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace rad::corpus {

struct JudgeOptions {
  std::string_view only;  ///< the one check to make; empty: all
  std::vector<std::string_view> skipped;
  bool variants = true;       ///< also repair the scene shuffled, moved, mirrored, and with two threads
  double slow_seconds = 120;  ///< repair is stopped after this, and fails
};

struct RepairFault {
  std::string_view check;
  std::string what;
};

struct RepairVerdict {
  bool was_clean = false;  ///< repair had nothing to do
  double seconds = 0;      ///< of the first repair, one thread
  double movement = 0;     ///< the largest that the ledger reports, T
  double lost = 0;         ///< how far a point deep inside an input face is from the result, T
  double added = 0;        ///< how far a point of the result is from the input, T
  std::vector<RepairFault> faults;
};

/// Repairs `scene` at `tolerance` (file units) and checks, each under its name:
/// "ends": not refused, not slow, nothing unresolved. "file": the GLB reads back as it was written, on the lattice.
/// "lint": no error of radlint in it at stages model and display. "exact": the brute-force lint finds nothing at T.
/// "lost": points with T of their face around them are within 8 T of the result. "added": the result is within 8 T of
/// the input. "movement": the ledger keeps the bounds of docs/repair.md. "again": repair of the file changes nothing.
/// "bytes": what is written of it then is the same to the byte, where the lattice of the file is taken over.
/// "threads", "order", "moved": the same bytes with two threads, shuffled, moved and scaled by powers of two.
/// "mirrored": in a mirror it ends clean as well.
RepairVerdict judge_repair(const scene::Scene& scene, double tolerance, const JudgeOptions& options);

std::vector<std::string_view> repair_checks();

}  // namespace rad::corpus
