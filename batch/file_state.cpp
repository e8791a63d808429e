#include "batch/file_state.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>

#include "readers/file_bytes.h"

namespace rad::batch {

namespace {

// The coarsest clock of a file system in use, FAT's two seconds, and some.
constexpr std::int64_t kClockTick = 2'500'000'000;  // ns

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

std::int64_t now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

bool is_proof(const FileState& state) {
  return std::max(state.stamp.modified, state.stamp.changed) < state.seen - kClockTick;
}

}  // namespace

std::optional<FileStamp> stamp_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileStamp{status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
                   nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

std::optional<FileState> state_of(const std::filesystem::path& path) {
  FileState state;
  state.seen = now();
  const auto stamp = stamp_of(path);
  readers::FileBytes file;
  if (!stamp || !file.open(path, UINT64_MAX, readers::FileKind::Regular).empty()) return std::nullopt;
  state.stamp = *stamp;
  state.content = digest128_of(file.bytes());
  return state;
}

bool is_as_it_was(const std::filesystem::path& path, const std::optional<FileState>& was) {
  const auto stamp = stamp_of(path);
  if (!was || !stamp) return !was && !stamp;
  if (stamp->size != was->stamp.size) return false;
  if (*stamp == was->stamp && is_proof(*was)) return true;
  const auto state = state_of(path);
  return state && state->content == was->content;
}

}  // namespace rad::batch
