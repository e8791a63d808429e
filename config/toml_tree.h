// TOML text as a tree of values that know their lines.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rad::config {

/// Files of configuration are not larger, values not nested deeper, and names have no more parts: what goes beyond was
/// not written by hand, and recursion over it could overflow the stack.
inline constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 20;  // bytes
inline constexpr int kDeepestValue = 16;
inline constexpr int kMostNameParts = 16;

struct Member;

struct Value {
  enum class Kind : unsigned char { Text, Number, Boolean, List, Table, Other };

  Kind kind = Kind::Other;
  std::uint64_t line = 0;       ///< 1-based
  std::string text;             ///< Text
  double number = 0;            ///< Number
  bool boolean = false;         ///< Boolean
  std::vector<Value> items;     ///< List
  std::vector<Member> members;  ///< Table, in the order of the file
};

struct Member {
  std::string key;
  std::uint64_t line = 0;
  Value value;
};

/// The table that a text is. Throws ConfigFault, naming `file`, for what is not TOML or goes beyond the limits above.
Value parse_toml(std::string_view text, const std::string& file);

/// The text of the file at `path`; messages name it `shown`. Throws ConfigFault where it cannot be read or is too
/// large.
std::string read_text(const std::string& path, const std::string& shown);

}  // namespace rad::config
