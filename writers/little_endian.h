// Numbers as the bytes of a little-endian file.
#pragma once

#include <bit>
#include <string>

namespace rad::writers {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

template <typename Number>
void append_bytes(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace rad::writers
