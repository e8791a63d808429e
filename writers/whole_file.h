// Files that are there in full or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rad::writers {

/// Writes `bytes` to a name of its own beside `path` and renames it. Returns what went wrong, empty for nothing; then
/// `path` is as it was before.
std::string write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace rad::writers
