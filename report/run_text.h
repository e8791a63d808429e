// Long lists of faces as short text: what a report says of where every face of the output came from.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rad::report {

/// Items one after the other, each a number or several. Tokens are separated by blanks:
///   `7`       one item: 7
///   `3..9`    seven items: 3, 4, … 9
///   `5*12`    twelve items: 5 each
///   `4+8-10`  one item that has several numbers: 4, 8, 9 and 10
class RunText {
 public:
  /// Adds an item; `numbers` ascend and are at least one.
  void add(std::span<const std::uint64_t> numbers);
  [[nodiscard]] std::size_t count() const { return count_; }
  std::string take();

 private:
  void add_single(std::uint64_t number);
  void flush();
  void open_token();

  std::string text_;
  std::size_t count_ = 0;
  std::uint64_t first_ = 0;
  std::uint64_t length_ = 0;  ///< of the run that is not written yet
  std::uint64_t step_ = 0;    ///< of a run of two or more: 0 or 1
};

}  // namespace rad::report
