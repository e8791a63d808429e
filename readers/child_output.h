// What another program says, run without a shell.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace rad::readers {

struct ChildOutput {
  std::string text;     ///< of its standard output
  std::string problem;  ///< why there is none, as a clause; empty where it ran to its end, whatever its exit code
};

/// Runs the program `words[0]`, looked up in PATH, with the other words as arguments, in `folder` (empty: the current
/// one) and without input. It is stopped when it says more than `limit` bytes or takes longer than `patience`.
ChildOutput output_of(const std::vector<std::string>& words, const std::string& folder, std::uint64_t limit,
                      std::chrono::seconds patience);

}  // namespace rad::readers
