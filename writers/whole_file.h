// Files that are there in full or not at all.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace rad::writers {

struct WholeFile {
  std::filesystem::path path;
  std::string_view bytes;
};

/// Writes all files to names of their own beside their paths, then renames them in order. Returns what went wrong,
/// empty for nothing. As long as not every byte could be written, every path is as it was before.
std::string write_whole_files(std::span<const WholeFile> files);

/// The same for one file.
std::string write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace rad::writers
