// Which file of one run is which of another.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rad::report {

struct PathPair {
  std::optional<std::size_t> old;
  std::optional<std::size_t> now;
};

/// Pairs of equal files: the only ones of their sides; else those whose paths end alike, longest common ends first, and
/// among equals those with the same suffix: a folder may have another name, and a model another format. What is
/// ambiguous stays alone. In the order of `now`; files that are gone come last.
std::vector<PathPair> pair_paths(std::span<const std::string> old, std::span<const std::string> now);

}  // namespace rad::report
