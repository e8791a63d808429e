#include "report/pair_inputs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

namespace rad::report {

namespace {

using Sides = std::array<std::vector<std::size_t>, 2>;

// Folders and file name, last first.
std::vector<std::string> components(const std::string& path) {
  std::vector<std::string> parts;
  for (const std::filesystem::path& part : std::filesystem::path(path).lexically_normal()) {
    parts.push_back(part.generic_string());
  }
  std::ranges::reverse(parts);
  return parts;
}

class PathPairs {
 public:
  PathPairs(std::span<const std::string> old, std::span<const std::string> now) : partner_(now.size()) {
    for (const std::string& path : old) parts_[0].push_back(components(path));
    for (const std::string& path : now) parts_[1].push_back(components(path));
    taken_[0].resize(old.size());
    taken_[1].resize(now.size());
  }

  std::vector<PathPair> run() {
    if (taken_[0].size() == 1 && taken_[1].size() == 1) take(0, 0);
    std::size_t deepest = 0;
    for (const auto& side : parts_) {
      for (const auto& parts : side) deepest = std::max(deepest, parts.size());
    }
    for (std::size_t depth = deepest; depth > 0; --depth) {
      for (const bool with_suffix : {true, false}) pair_at(depth, with_suffix);
    }
    std::vector<PathPair> pairs;
    for (std::size_t now = 0; now < partner_.size(); ++now) pairs.push_back({partner_[now], now});
    for (std::size_t old = 0; old < taken_[0].size(); ++old) {
      if (!taken_[0][old]) pairs.push_back({old, std::nullopt});
    }
    return pairs;
  }

 private:
  void take(std::size_t old, std::size_t now) {
    partner_[now] = old;
    taken_[0][old] = taken_[1][now] = true;
  }

  void pair_at(std::size_t depth, bool with_suffix) {
    std::map<std::vector<std::string>, Sides> ends;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t i = 0; i < parts_[side].size(); ++i) {
        if (taken_[side][i] || parts_[side][i].size() < depth) continue;
        std::vector<std::string> end(parts_[side][i].begin(),
                                     parts_[side][i].begin() + static_cast<std::ptrdiff_t>(depth));
        if (!with_suffix) end.front() = std::filesystem::path(end.front()).stem().generic_string();
        ends[std::move(end)][side].push_back(i);
      }
    }
    for (const auto& [end, sides] : ends) {
      if (sides[0].size() == 1 && sides[1].size() == 1) take(sides[0].front(), sides[1].front());
    }
  }

  std::array<std::vector<std::vector<std::string>>, 2> parts_;
  std::array<std::vector<bool>, 2> taken_;
  std::vector<std::optional<std::size_t>> partner_;
};

}  // namespace

std::vector<PathPair> pair_paths(std::span<const std::string> old, std::span<const std::string> now) {
  return PathPairs(old, now).run();
}

}  // namespace rad::report
