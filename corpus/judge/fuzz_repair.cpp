#include "corpus/judge/fuzz_repair.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "corpus/judge/shrink.h"

namespace rad::corpus {
namespace {

class Run {
 public:
  Run(const FuzzOptions& options, const std::function<void(const FuzzFailure&)>& failed)
      : options_(options), failed_(failed), scenes_(options.kinds.size() * seeds()) {
    for (const HardKind* kind : options.kinds) summaries_.emplace_back().kind = kind->name;
  }

  std::vector<KindSummary> run() {
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < options_.jobs; ++i) workers.emplace_back([this] { work(); });
    workers.clear();
    return std::move(summaries_);
  }

 private:
  [[nodiscard]] std::size_t seeds() const {
    return options_.last_seed < options_.first_seed ? 0 : options_.last_seed - options_.first_seed + 1;
  }
  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  void work() {
    while (elapsed() < options_.seconds) {
      const std::size_t next = next_++;
      if (next >= scenes_) return;
      const std::size_t kind = next % options_.kinds.size();
      judge_one(kind, options_.first_seed + next / options_.kinds.size());
    }
  }

  void judge_one(std::size_t index, std::uint64_t seed) {
    const HardKind* kind = options_.kinds[index];
    const HardScene scene = hard_scene(*kind, seed, options_.size);
    const RepairVerdict verdict = judge_repair(scene.scene, scene.tolerance, options_.judge);
    const std::scoped_lock lock(mutex_);
    KindSummary& summary = summaries_[index];
    ++summary.scenes;
    summary.clean += verdict.was_clean ? 1 : 0;
    if (verdict.seconds > summary.worst_seconds) summary.slowest_seed = seed;
    summary.worst_seconds = std::max(summary.worst_seconds, verdict.seconds);
    summary.worst_movement = std::max(summary.worst_movement, verdict.movement);
    summary.worst_lost = std::max(summary.worst_lost, verdict.lost);
    summary.worst_added = std::max(summary.worst_added, verdict.added);
    if (verdict.faults.empty()) return;
    ++summary.failed;
    failed_({kind, seed, verdict});
  }

  const FuzzOptions& options_;
  const std::function<void(const FuzzFailure&)>& failed_;
  std::size_t scenes_;
  std::atomic<std::size_t> next_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::vector<KindSummary> summaries_;
};

}  // namespace

std::vector<KindSummary> fuzz_repair(const FuzzOptions& options,
                                     const std::function<void(const FuzzFailure&)>& failed) {
  return Run(options, failed).run();
}

std::string table(const std::vector<KindSummary>& summaries) {
  std::string text = fmt::format("{:<22} {:>6} {:>6} {:>6} {:>9} {:>8} {:>7} {:>7} {:>7}\n", "kind", "scenes", "clean",
                                 "failed", "worst s", "its seed", "moved T", "lost T", "added T");
  for (const KindSummary& s : summaries) {
    text +=
        fmt::format("{:<22} {:>6} {:>6} {:>6} {:>9.2f} {:>8} {:>7.2f} {:>7.2f} {:>7.2f}\n", s.kind, s.scenes, s.clean,
                    s.failed, s.worst_seconds, s.slowest_seed, s.worst_movement, s.worst_lost, s.worst_added);
  }
  return text;
}

scene::Scene shrunken_scene(const HardScene& scene, std::string_view check, const JudgeOptions& judge) {
  JudgeOptions options = judge;
  options.only = check;
  return shrunken(scene.scene, [&](const scene::Scene& smaller) {
    return !judge_repair(smaller, scene.tolerance, options).faults.empty();
  });
}

}  // namespace rad::corpus
