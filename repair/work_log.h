// What a run of repair did and how long it took, written down while it runs.
#pragma once

#include "repair/conform.h"
#include "scene/ledger.h"

namespace rad::repair {

class WorkLog {
 public:
  /// Adds an entry unless nothing was done. `movement` in file units, `area_change` in file units².
  void record(const char* stage, const char* operation, std::size_t count, double movement = 0,
              std::optional<double> area_change = std::nullopt);
  /// All operations of Grouper and Isect. `pitch`: of the lattice, file units.
  void record(const ConformCounts& counts, double pitch);

  /// The time since the last lap belongs to `stage`.
  void lap(const char* stage);
  void add_time(const char* stage, const Spent& spent);
  /// Starts a lap: the time so far has been added otherwise.
  void restart() { watch_.lap(); }

  scene::Ledger ledger;
  scene::StageTimings timings;      ///< on the wall
  scene::StageTimings cpu_timings;  ///< of all threads

 private:
  Stopwatch watch_;
};

/// Ids of the rules that an operation of the ledger serves; empty for an operation that is not known.
std::vector<std::string> rules_served_by(std::string_view operation);

}  // namespace rad::repair
