// A hash table from unordered pairs of ids to values, which keeps its entries in the order they were added.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace rad::mesh {

template <typename Value>
class PairTable {
 public:
  /// The value of the pair, or nullptr.
  [[nodiscard]] const Value* find(std::uint32_t a, std::uint32_t b) const {
    if (slots_.empty()) return nullptr;
    const std::uint32_t entry = slots_[slot_of(ordered(a, b))];
    return entry == kEmpty ? nullptr : &entries_[entry].value;
  }

  /// The value of the pair, made from `Value{}` where it is new. Valid until the next call.
  Value& at(std::uint32_t a, std::uint32_t b) {
    if (2 * (entries_.size() + 1) > slots_.size()) grow();
    const Key key = ordered(a, b);
    std::uint32_t& slot = slots_[slot_of(key)];
    if (slot == kEmpty) {
      slot = static_cast<std::uint32_t>(entries_.size());
      entries_.push_back({key, Value{}});
    }
    return entries_[slot].value;
  }

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] std::size_t memory_bytes() const {
    return entries_.size() * sizeof(Entry) + slots_.size() * sizeof(std::uint32_t);
  }

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;
  struct Entry {
    Key key;
    Value value;
  };
  static constexpr std::uint32_t kEmpty = 0xffffffffU;
  static constexpr std::size_t kFirstSlots = 64;

  static Key ordered(std::uint32_t a, std::uint32_t b) { return a < b ? Key{a, b} : Key{b, a}; }

  // Linear probing; the number of slots is a power of two and at most half of them are taken.
  [[nodiscard]] std::size_t slot_of(const Key& key) const {
    std::uint64_t mixed = std::uint64_t{key.first} << 32 | key.second;
    mixed = (mixed ^ mixed >> 29) * 0x9e3779b97f4a7c15U;
    mixed = (mixed ^ mixed >> 32) * 0x9e3779b97f4a7c15U;
    mixed ^= mixed >> 32;
    std::size_t slot = mixed & (slots_.size() - 1);
    while (slots_[slot] != kEmpty && entries_[slots_[slot]].key != key) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow() {
    slots_.assign(slots_.empty() ? kFirstSlots : 2 * slots_.size(), kEmpty);
    for (std::uint32_t entry = 0; entry < entries_.size(); ++entry) slots_[slot_of(entries_[entry].key)] = entry;
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace rad::mesh
