// Values as bytes and back, by one description of each: what an object is made of is said once, for both ways.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "geom/vec.h"

namespace rad::scene {

/// The bytes end too early, or say what cannot be.
struct BadBytes : std::runtime_error {
  BadBytes() : std::runtime_error("not a record") {}
};

/// Appends values. Whole numbers take seven bits a byte, doubles their eight bytes.
class ByteWriter {
 public:
  static constexpr bool kWrites = true;

  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(value | 0x80);
    bytes_ += static_cast<char>(value);
  }
  void real(double value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes_.append(raw, sizeof value);
  }
  void text(std::string_view value) {
    number(value.size());
    bytes_ += value;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Takes them back. Throws BadBytes; never takes more memory than a small multiple of the bytes.
class ByteReader {
 public:
  static constexpr bool kWrites = false;

  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const auto byte = static_cast<unsigned char>(take(1).front());
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80) return value;
    }
    throw BadBytes();
  }
  double real() {
    double value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view text() { return take(count()); }
  /// A number of things that take at least a byte each.
  std::size_t count() {
    const std::uint64_t value = number();
    if (value > rest_.size()) throw BadBytes();
    return static_cast<std::size_t>(value);
  }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) throw BadBytes();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
};

/// exchange(archive, value) writes the value to a ByteWriter or reads it from a ByteReader. Who has overloads for
/// further types in another namespace derives archives there, so that they are found.
template <typename Archive, typename Value>
requires(std::is_integral_v<Value> || std::is_enum_v<Value>) void exchange(Archive& archive, Value& value) {
  if constexpr (Archive::kWrites) {
    archive.number(static_cast<std::uint64_t>(value));
  } else {
    value = static_cast<Value>(archive.number());
  }
}

template <typename Archive>
void exchange(Archive& archive, double& value) {
  if constexpr (Archive::kWrites) {
    archive.real(value);
  } else {
    value = archive.real();
  }
}

template <typename Archive>
void exchange(Archive& archive, std::string& value) {
  if constexpr (Archive::kWrites) {
    archive.text(value);
  } else {
    value = archive.text();
  }
}

template <typename Archive>
void exchange(Archive& archive, geom::dvec3& value) {
  for (int axis = 0; axis < 3; ++axis) exchange(archive, value[axis]);
}

template <typename Archive, typename Value, std::size_t kCount>
void exchange(Archive& archive, std::array<Value, kCount>& values) {
  for (Value& value : values) exchange(archive, value);
}

template <typename Archive, typename Value>
void exchange(Archive& archive, std::optional<Value>& value) {
  bool there = value.has_value();
  exchange(archive, there);
  if (!Archive::kWrites && there) value.emplace();
  if (there) exchange(archive, *value);
}

template <typename Archive, typename Value>
void exchange(Archive& archive, std::vector<Value>& values) {
  if constexpr (Archive::kWrites) {
    archive.number(values.size());
  } else {
    values.resize(archive.count());
  }
  for (Value& value : values) exchange(archive, value);
}

/// Several values in order.
template <typename Archive, typename... Values>
requires(sizeof...(Values) > 1) void exchange_all(Archive& archive, Values&... values) {
  (exchange(archive, values), ...);
}

}  // namespace rad::scene
