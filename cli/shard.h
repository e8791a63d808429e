// Dividing a run among machines.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rad::cli {

struct ShardChoice {
  std::size_t index = 1;  ///< 1 to count
  std::size_t count = 1;
};

/// "2/4"; nothing for other words.
std::optional<ShardChoice> parse_shard(std::string_view word);

/// Positions of the paths that belong to the shard, ascending. A path belongs to the same shard whatever other files
/// there are, so that what a machine has cached stays of use to it.
std::vector<std::size_t> positions_in_shard(const std::vector<std::string>& paths, const ShardChoice& shard);

}  // namespace rad::cli
