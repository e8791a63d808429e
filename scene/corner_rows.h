// Rows for the values of corners: equal values get one row, numbered in the order of first use.
#pragma once

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/corner_values.h"

namespace rad::scene {

/// Fills the table of corner values.
template <typename Value>
class CornerRows {
 public:
  explicit CornerRows(std::vector<Value>& table) : table_(table) {}

  RowId row(const Value& value) {
    const auto [entry, fresh] = rows_.try_emplace(value, static_cast<RowId>(table_.size()));
    if (fresh) table_.push_back(value);
    return entry->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const Value& value) const {
      std::uint64_t hash = 0;
      for (int i = 0; i < static_cast<int>(Value::length()); ++i) {
        // Zeros of both signs are equal, and must hash alike.
        hash = (hash ^ std::bit_cast<std::uint64_t>(value[i] + 0.0)) * 0x9e3779b97f4a7c15ull;
        hash ^= hash >> 32;
      }
      return static_cast<std::size_t>(hash);
    }
  };

  std::vector<Value>& table_;
  std::unordered_map<Value, RowId, Hash> rows_;
};

}  // namespace rad::scene
