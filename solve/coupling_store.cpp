#include "solve/coupling_store.h"

#include <algorithm>

namespace rad::solve {
namespace {

/// So many ranges keep a few dozen cores busy, and the table of places small beside what it points to.
constexpr std::size_t kMostRanges = 128;
constexpr std::size_t kFewestReceivers = 64;

}  // namespace

CouplingStore::CouplingStore(const CouplingSource& source, std::size_t budget_bytes)
    : source_(source), budget_(budget_bytes) {
  const std::size_t count = source.receivers.size();
  const std::size_t length = std::max(kFewestReceivers, (count + kMostRanges - 1) / kMostRanges);
  for (std::size_t first = 0; first < count; first += length) {
    ranges_.push_back({static_cast<ReceiverId>(first), static_cast<ReceiverId>(std::min(count, first + length))});
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
