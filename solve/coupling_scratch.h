// Memory that coupling one patch after the other needs again and again.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/receivers.h"

namespace rad::solve {

/// Numbers receivers in the order in which they are added, each once. Made for a number of receivers, emptied at once.
class ReceiverSet {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  explicit ReceiverSet(std::size_t receivers) : number_(receivers, 0) {}

  void clear() { list_.clear(); }
  [[nodiscard]] std::uint32_t find(ReceiverId receiver) const {
    const std::uint32_t number = number_[receiver];
    return number < list_.size() && list_[number] == receiver ? number : kNone;
  }
  /// True where it was not there yet.
  bool add(ReceiverId receiver) {
    if (find(receiver) != kNone) return false;
    number_[receiver] = static_cast<std::uint32_t>(list_.size());
    list_.push_back(receiver);
    return true;
  }
  [[nodiscard]] const std::vector<ReceiverId>& list() const { return list_; }

 private:
  std::vector<std::uint32_t> number_;
  std::vector<ReceiverId> list_;
};

/// For one thread.
struct CouplingScratch {
  explicit CouplingScratch(std::size_t receivers) : far(receivers), near(receivers) {}

  ReceiverSet far;
  ReceiverSet near;
};

}  // namespace rad::solve
