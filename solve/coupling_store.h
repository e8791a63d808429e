// Couplings kept in memory up to a budget, since they depend on geometry alone and a patch is shot more than once.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "solve/coupling.h"

namespace rad::solve {

/// Patches in ranges, and for each patch and range a place for its coupling. What is not kept is computed again, with
/// the same numbers.
class CouplingStore {
 public:
  CouplingStore(const CouplingSource& source, std::size_t budget_bytes);

  [[nodiscard]] const std::vector<PatchRange>& ranges() const { return ranges_; }

  /// Calls use(coupling) with the coupling of a patch to ranges()[range]. Not for the same pair from two threads at
  /// once.
  template <typename Use>
  void with(mesh::PatchId patch, std::size_t range, Use&& use) {
    std::unique_ptr<const Coupling>& kept = kept_[patch * ranges_.size() + range];
    if (kept) return use(*kept);
    auto made = std::make_unique<const Coupling>(couple(source_, patch, ranges_[range], scratch_.local()));
    use(*made);
    if (take(made->bytes())) kept = std::move(made);
  }

 private:
  bool take(std::size_t bytes);

  const CouplingSource& source_;
  std::vector<PatchRange> ranges_;
  std::vector<std::unique_ptr<const Coupling>> kept_;
  tbb::enumerable_thread_specific<CouplingScratch> scratch_;
  std::size_t budget_;
  std::atomic<std::size_t> used_{0};
};

}  // namespace rad::solve
