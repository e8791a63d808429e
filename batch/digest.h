// A 128-bit digest of content, for telling whether something has changed; no defence against those who mean harm.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace rad::batch {

using Digest128 = std::array<std::uint64_t, 2>;

Digest128 digest128_of(std::string_view bytes);

class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  /// Adds a text and its length, so that "a", "bc" and "ab", "c" differ.
  Digest& add(std::string_view text);
  /// 32 hex digits.
  [[nodiscard]] std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// 32 hex digits.
std::string digest_of(std::string_view bytes);

}  // namespace rad::batch
