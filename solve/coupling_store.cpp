#include "solve/coupling_store.h"

#include <algorithm>

namespace rad::solve {
namespace {

/// So many ranges keep a few dozen cores busy, and what is done once for a radiator and a range small beside the rest.
constexpr std::size_t kMostRanges = 64;
constexpr std::size_t kFewestLocals = 128;

}  // namespace

CouplingStore::CouplingStore(const CouplingSource& source, std::size_t budget_bytes)
    : source_(source), scratch_(source.receivers.size()), budget_(budget_bytes) {
  const std::size_t locals = source.radiators.local_receiver.size();
  const std::size_t length = std::max(kFewestLocals, (locals + kMostRanges - 1) / kMostRanges);
  const auto patches = static_cast<mesh::PatchId>(source.mesh.patches.size());
  PatchRange range;
  for (std::size_t held = 0; range.end < patches;) {
    held += source.radiators.patch[range.end++].local_count;
    if (held < length && range.end < patches) continue;
    ranges_.push_back(range);
    range.first = range.end;
    held = 0;
  }
  kept_.resize(source.mesh.patches.size() * ranges_.size());
}

bool CouplingStore::take(std::size_t bytes) {
  const std::size_t before = used_.fetch_add(bytes);
  if (before + bytes <= budget_) return true;
  used_.fetch_sub(bytes);
  return false;
}

}  // namespace rad::solve
