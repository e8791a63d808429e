#include "cli/threads.h"

#include <tbb/global_control.h>

namespace rad::cli {

struct Threads::Limit {
  tbb::global_control control;
};

Threads::Threads(std::size_t count) {
  if (count == 0) return;
  limit_ = std::make_unique<Limit>(Limit{{tbb::global_control::max_allowed_parallelism, count}});
}

Threads::~Threads() = default;

}  // namespace rad::cli
