#include "cli/shard.h"

#include <charconv>

#include "batch/digest.h"

namespace rad::cli {

namespace {

std::optional<std::size_t> number_of(std::string_view word) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

// Sixty bits of the digest of a path.
std::uint64_t place_of(const std::string& path) {
  const std::string digits = batch::digest_of(path).substr(0, 15);
  std::uint64_t place = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), place, 16);
  return place;
}

}  // namespace

std::optional<ShardChoice> parse_shard(std::string_view word) {
  const std::size_t slash = word.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto index = number_of(word.substr(0, slash)), count = number_of(word.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count) return std::nullopt;
  return ShardChoice{*index, *count};
}

std::vector<std::size_t> positions_in_shard(const std::vector<std::string>& paths, const ShardChoice& shard) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (place_of(paths[i]) % shard.count == shard.index - 1) positions.push_back(i);
  }
  return positions;
}

}  // namespace rad::cli
