// A 128-bit digest of content, for telling whether something has changed; no defence against those who mean harm.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace rad::batch {

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

std::string digest_of(std::string_view bytes);

/// Of a regular file; nothing where it cannot be read.
std::optional<std::string> digest_of_file(const std::filesystem::path& path);

}  // namespace rad::batch
