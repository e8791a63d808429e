// How many threads a run may use.
#pragma once

#include <cstddef>
#include <memory>

namespace rad::cli {

/// Holds the run to `count` threads for as long as it lives; 0 leaves all.
class Threads {
 public:
  explicit Threads(std::size_t count);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  struct Limit;
  std::unique_ptr<Limit> limit_;
};

}  // namespace rad::cli
