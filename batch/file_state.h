// How a file is, told quickly or for certain.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "batch/digest.h"

namespace rad::batch {

/// What the file system says of a regular file. Times are nanoseconds since 1970.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;
  std::int64_t modified = 0;
  std::int64_t changed = 0;  ///< also by what keeps the time of modification

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Nothing where there is no regular file that can be asked.
std::optional<FileStamp> stamp_of(const std::filesystem::path& path);

/// Stamp and content of a file at a time.
struct FileState {
  FileStamp stamp;
  Digest128 content{};
  std::int64_t seen = 0;  ///< nanoseconds since 1970, before either was looked at
};

/// Nothing where there is no regular file that can be read.
std::optional<FileState> state_of(const std::filesystem::path& path);

/// Whether the file is as it was: by its stamp where that is proof, else by its content. Nothing for `was`: whether
/// there is still none. A stamp proves nothing where the file was changed so shortly before it was seen that the next
/// change could bear the same time.
bool is_as_it_was(const std::filesystem::path& path, const std::optional<FileState>& was);

}  // namespace rad::batch
