#include "repair/work_log.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rad::repair {
namespace {

using Served = std::pair<std::string_view, std::array<const char*, 3>>;

constexpr std::array<Served, 13> kServed{{
    {"turn-face", {"RL110", "RL104"}},
    {"weld", {"RL302", "RL005"}},
    {"snap-to-plane", {"RL008"}},
    {"drop-collapsed", {"RL007"}},
    {"insert-t-vertex", {"RL201", "RL301"}},
    {"add-point", {"RL210", "RL211"}},
    {"split-edge", {"RL210", "RL211"}},
    {"imprint", {"RL210", "RL211"}},
    {"merge-points", {"RL210", "RL211"}},
    {"add-steiner-point", {"RL210", "RL211"}},
    {"move-to-plane", {"RL220", "RL221"}},
    {"remove-covered-cell", {"RL220", "RL221"}},
    {"drop-bad-faces", {"RL002", "RL003"}},
}};

void add_to(scene::StageTimings& timings, const char* stage, double seconds) {
  const auto found = std::ranges::find(timings, stage, &std::pair<std::string, double>::first);
  if (found == timings.end()) {
    timings.emplace_back(stage, seconds);
  } else {
    found->second += seconds;
  }
}

}  // namespace

void WorkLog::record(const char* stage, const char* operation, std::size_t count, double movement,
                     std::optional<double> area_change) {
  if (count == 0) return;
  ledger.push_back({stage, operation, rules_served_by(operation), count, movement, area_change});
}

void WorkLog::record(const ConformCounts& counts, double pitch) {
  record("grouper", "weld", counts.welded, counts.largest_weld * pitch);
  record("grouper", "snap-to-plane", counts.snapped.moved, counts.snapped.largest * pitch);
  record("grouper", "drop-collapsed", counts.collapsed);
  record("grouper", "insert-t-vertex", counts.t_vertices);
  record("isect", "add-point", counts.complex.new_points);
  record("isect", "split-edge", counts.complex.splits - counts.t_vertices);
  record("isect", "imprint", counts.complex.imprints);
  record("isect", "merge-points", counts.complex.merges, counts.complex.largest_merge * pitch);
  record("isect", "add-steiner-point", counts.residual.steiner_points);
  record("coplanar", "move-to-plane", counts.residual.rehomed);
}

void WorkLog::lap(const char* stage) { add_time(stage, watch_.lap()); }

void WorkLog::add_time(const char* stage, const Spent& spent) {
  add_to(timings, stage, spent.wall);
  add_to(cpu_timings, stage, spent.cpu);
}

std::vector<std::string> rules_served_by(std::string_view operation) {
  const auto* const found = std::ranges::find(kServed, operation, &Served::first);
  if (found == kServed.end()) return {};
  std::vector<std::string> rules;
  for (const char* rule : found->second) {
    if (rule != nullptr) rules.emplace_back(rule);
  }
  return rules;
}

}  // namespace rad::repair
