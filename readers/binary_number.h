// Numbers out of the bytes of a file, on machines of either byte order.
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstring>

namespace rad::readers {

/// The number that sizeof(Number) bytes hold in the byte order of the file.
template <typename Number, std::endian kOrder>
requires std::integral<Number> || std::floating_point<Number> Number binary_number(const char* bytes) {
  char raw[sizeof(Number)];
  std::memcpy(raw, bytes, sizeof raw);
  if constexpr (kOrder != std::endian::native) std::reverse(raw, raw + sizeof raw);
  Number number;
  std::memcpy(&number, raw, sizeof raw);
  return number;
}

}  // namespace rad::readers
