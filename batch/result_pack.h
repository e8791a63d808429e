// Many results in one file, found by their keys.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "batch/digest.h"
#include "readers/file_bytes.h"

namespace rad::batch {

/// A file of results: each with its key, a day, and a checksum that is looked at before a result is believed. What is
/// damaged is not there. Other processes may replace the file at any time; this one reads what was there at first.
class ResultPack {
 public:
  /// Results that no run has used for so many days are left out when the file is written.
  static constexpr std::uint32_t kDaysKept = 14;

  explicit ResultPack(std::filesystem::path file);

  /// Valid until save().
  [[nodiscard]] std::optional<std::string_view> find(const Digest128& key) const;

  void add(const Digest128& key, std::string result) { fresh_.insert_or_assign(key, std::move(result)); }

  /// Writes the file anew where something was added: with that, with what others have written meanwhile, and with what
  /// was used, of all that at most `most_bytes`, the youngest. Nothing happens where it cannot be written.
  void save(std::uint64_t most_bytes);

 private:
  struct Hash {
    std::size_t operator()(const Digest128& key) const { return key[0]; }
  };
  struct Slot {
    std::string_view result;
    std::uint64_t checksum = 0;
    std::uint32_t day = 0;
    mutable bool used = false;
  };
  using Slots = std::unordered_map<Digest128, Slot, Hash>;

  static Slots slots_in(std::string_view bytes);
  [[nodiscard]] std::string content(const Slots& others, std::uint64_t most_bytes) const;

  std::filesystem::path file_;
  readers::FileBytes bytes_;
  Slots slots_;
  std::map<Digest128, std::string> fresh_;
};

}  // namespace rad::batch
