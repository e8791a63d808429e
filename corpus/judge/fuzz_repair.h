// Judging the repair of many hard scenes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "corpus/hard/kinds.h"
#include "corpus/judge/repair_judge.h"

namespace rad::corpus {

struct FuzzOptions {
  std::vector<const HardKind*> kinds;
  std::uint64_t first_seed = 1, last_seed = 100;
  int size = 1;          ///< of the scenes; see HardSketch
  std::size_t jobs = 1;  ///< scenes judged at a time; each is repaired with one thread
  double seconds = 1e9;  ///< after which no further scene is begun
  JudgeOptions judge;
};

struct KindSummary {
  std::string_view kind;
  std::size_t scenes = 0;
  std::size_t clean = 0;  ///< nothing to repair
  std::size_t failed = 0;
  double worst_seconds = 0;
  std::uint64_t slowest_seed = 0;
  double worst_movement = 0, worst_lost = 0, worst_added = 0;  ///< T
};

struct FuzzFailure {
  const HardKind* kind;
  std::uint64_t seed;
  RepairVerdict verdict;
};

/// Seeds in order, of each all kinds. `failed` is called for each failing scene as it is found, one at a time.
std::vector<KindSummary> fuzz_repair(const FuzzOptions& options, const std::function<void(const FuzzFailure&)>& failed);

std::string table(const std::vector<KindSummary>& summaries);

/// The scene of a kind and a seed, shrunken while `check` fails.
scene::Scene shrunken_scene(const HardScene& scene, std::string_view check, const JudgeOptions& judge);

}  // namespace rad::corpus
