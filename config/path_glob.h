// Patterns of paths: * and ? within a name, ** across folders.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rad::config {

/// Whether the whole of `path`, with '/' between its names, matches. `*`, `?` and `[a-z]` stay within one name; a name
/// that is `**` stands for any number of folders, also for none.
bool path_matches(std::string_view glob, std::string_view path);

/// A pattern as a user wrote it, and the folder it is relative to.
struct PathPattern {
  std::string glob;
  std::filesystem::path base;  ///< absolute

  /// Whether the pattern names `path` (absolute, lexically normal) or a folder above it. A pattern without a slash
  /// names whatever has this name, at any depth below `base`; others are matched from `base` on.
  [[nodiscard]] bool covers(const std::filesystem::path& path) const;
};

}  // namespace rad::config
