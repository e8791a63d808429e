#include "batch/result_pack.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <vector>

#include "writers/whole_file.h"

namespace rad::batch {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead = "radlint results 2\n";

/// What stands before each result; its own checksum is over the members before it.
struct SlotHead {
  Digest128 key{};
  std::uint64_t bytes = 0;
  std::uint64_t checksum = 0;  ///< of the result
  std::uint64_t day = 0;       ///< since 1970
  std::uint64_t head_checksum = 0;
};

std::uint64_t checksum_of(std::string_view bytes) { return digest128_of(bytes)[0]; }

std::uint64_t checksum_of(const SlotHead& head) {
  std::array<char, offsetof(SlotHead, head_checksum)> bytes;
  std::memcpy(bytes.data(), &head, bytes.size());
  return checksum_of(std::string_view(bytes.data(), bytes.size()));
}

std::uint32_t today() {
  return static_cast<std::uint32_t>(
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()).time_since_epoch().count());
}

/// Holds a folder while a file in it is replaced, so that no process overwrites what another has just written.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

 private:
  int descriptor_;
};

void append(std::string& into, const Digest128& key, std::string_view result, std::uint32_t day) {
  SlotHead head{key, result.size(), checksum_of(result), day, 0};
  head.head_checksum = checksum_of(head);
  into.append(reinterpret_cast<const char*>(&head), sizeof head);
  into += result;
}

}  // namespace

ResultPack::ResultPack(fs::path file) : file_(std::move(file)) {
  if (bytes_.open(file_, UINT64_MAX, readers::FileKind::Regular).empty()) slots_ = slots_in(bytes_.bytes());
}

ResultPack::Slots ResultPack::slots_in(std::string_view bytes) {
  Slots slots;
  if (!bytes.starts_with(kHead)) return slots;
  bytes.remove_prefix(kHead.size());
  while (bytes.size() >= sizeof(SlotHead)) {
    SlotHead head;
    std::memcpy(&head, bytes.data(), sizeof head);
    bytes.remove_prefix(sizeof head);
    // What follows a damaged head cannot be found.
    if (head.head_checksum != checksum_of(head) || head.bytes > bytes.size()) return slots;
    slots[head.key] = {bytes.substr(0, head.bytes), head.checksum, static_cast<std::uint32_t>(head.day)};
    bytes.remove_prefix(head.bytes);
  }
  return slots;
}

std::optional<std::string_view> ResultPack::find(const Digest128& key) const {
  if (const auto fresh = fresh_.find(key); fresh != fresh_.end()) return fresh->second;
  const auto slot = slots_.find(key);
  if (slot == slots_.end() || checksum_of(slot->second.result) != slot->second.checksum) return std::nullopt;
  slot->second.used = true;
  return slot->second.result;
}

std::string ResultPack::content(const Slots& others, std::uint64_t most_bytes) const {
  struct Kept {
    Digest128 key;
    std::string_view result;
    std::uint32_t day = 0;
  };
  const std::uint32_t day = today();
  std::vector<Kept> all;
  for (const auto& [key, result] : fresh_) all.push_back({key, result, day});
  for (const auto& [key, slot] : others) {
    const auto mine = slots_.find(key);
    const std::uint32_t used = mine != slots_.end() && mine->second.used ? day : slot.day;
    const bool damaged = checksum_of(slot.result) != slot.checksum;
    if (!fresh_.contains(key) && !damaged && used + kDaysKept >= day) all.push_back({key, slot.result, used});
  }
  std::ranges::sort(all, [](const Kept& x, const Kept& y) { return std::tie(y.day, x.key) < std::tie(x.day, y.key); });
  std::string bytes(kHead);
  for (const Kept& kept : all) {
    if (bytes.size() + sizeof(SlotHead) + kept.result.size() > most_bytes) break;
    append(bytes, kept.key, kept.result, kept.day);
  }
  return bytes;
}

void ResultPack::save(std::uint64_t most_bytes) {
  if (fresh_.empty()) return;
  std::error_code error;
  fs::create_directories(file_.parent_path(), error);
  if (error) return;
  const FolderLock lock(file_.parent_path());
  readers::FileBytes now;
  Slots others;
  if (now.open(file_, UINT64_MAX, readers::FileKind::Regular).empty()) others = slots_in(now.bytes());
  static_cast<void>(writers::write_whole_file(file_, content(others, most_bytes)));
  fresh_.clear();
}

}  // namespace rad::batch
