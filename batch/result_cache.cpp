#include "batch/result_cache.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "scene/byte_archive.h"

namespace rad::batch {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSuffix = ".results";

struct Companion {
  std::string path;
  std::optional<FileState> state;
};

}  // namespace

// The overloads below are looked up by these, so they are in no namespace without a name.
class EntryWriter : public scene::ByteWriter {};
class EntryReader : public scene::ByteReader {
 public:
  using ByteReader::ByteReader;
};

template <typename Archive>
static void exchange(Archive& archive, FileStamp& stamp) {
  exchange_all(archive, stamp.device, stamp.inode, stamp.size, stamp.modified, stamp.changed);
}

template <typename Archive>
static void exchange(Archive& archive, FileState& state) {
  exchange_all(archive, state.stamp, state.content, state.seen);
}

template <typename Archive>
static void exchange(Archive& archive, Companion& companion) {
  exchange_all(archive, companion.path, companion.state);
}

namespace {

/// An entry, taken apart.
struct Entry {
  explicit Entry(std::string_view bytes) {
    EntryReader reader(bytes);
    exchange(reader, model);
    exchange(reader, companions);
    result = reader.text();
  }

  [[nodiscard]] bool holds(const std::string& path) const {
    return is_as_it_was(path, model) && std::ranges::all_of(companions, [](const Companion& companion) {
             return is_as_it_was(companion.path, companion.state);
           });
  }

  FileState model;
  std::vector<Companion> companions;
  std::string_view result;
};

struct Kept {
  fs::file_time_type used;
  std::uint64_t bytes = 0;
  fs::path path;
};

std::vector<Kept> packs_in(const fs::path& folder) {
  std::vector<Kept> packs;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (entry->path().extension() != kSuffix || !entry->is_regular_file(gone)) continue;
    Kept kept{entry->last_write_time(gone), 0, entry->path()};
    if (!gone) kept.bytes = entry->file_size(gone);
    if (!gone) packs.push_back(std::move(kept));
  }
  return packs;
}

// Once a day is enough to tell what is in use.
void note_use(const fs::path& file) {
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  const auto used = fs::last_write_time(file, error);
  if (!error && used < now - std::chrono::hours(24)) fs::last_write_time(file, now, error);
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

Digest128 key_of(const std::string& path, const Digest128& settings) {
  std::string text = path;
  for (const std::uint64_t half : settings) text.append(reinterpret_cast<const char*>(&half), sizeof half);
  return digest128_of(text);
}

}  // namespace

std::string entry_of(const FileState& model, std::string_view result, const std::vector<fs::path>& companions) {
  EntryWriter writer;
  FileState state = model;
  std::vector<Companion> states;
  for (const fs::path& path : companions) states.push_back({path.string(), state_of(path)});
  exchange(writer, state);
  exchange(writer, states);
  writer.text(result);
  return writer.take();
}

std::string_view result_of(std::string_view entry) { return Entry(entry).result; }

ResultCache::ResultCache(fs::path folder, std::string tool, std::uint64_t most_bytes)
    : folder_(std::move(folder)), tool_(std::move(tool)), most_bytes_(most_bytes) {}

ResultPack& ResultCache::pack_of(const std::string& path) {
  std::string models = folder_of(path);
  const auto known = packs_.find(models);
  if (known != packs_.end()) return *known->second;
  std::error_code error;
  const std::string absolute = fs::absolute(models.empty() ? "." : models, error).lexically_normal().string();
  const fs::path file = folder_ / (digest_of(tool_ + absolute) + std::string(kSuffix));
  note_use(file);
  return *packs_.emplace(std::move(models), std::make_unique<ResultPack>(file)).first->second;
}

std::optional<std::string_view> ResultCache::find(const std::string& path, const Digest128& settings) {
  const auto bytes = pack_of(path).find(key_of(path, settings));
  if (!bytes) return std::nullopt;
  try {
    const Entry entry(*bytes);
    return entry.holds(path) ? std::optional(entry.result) : std::nullopt;
  } catch (const scene::BadBytes&) {
    return std::nullopt;
  }
}

void ResultCache::keep(const std::string& path, const Digest128& settings, std::string entry) {
  pack_of(path).add(key_of(path, settings), std::move(entry));
  changed_ = true;
}

void ResultCache::save() {
  if (!changed_) return;
  changed_ = false;
  for (const auto& [models, pack] : packs_) pack->save(most_bytes_);
  packs_.clear();
  trim();
}

// Down to nine tenths, so that not every run has to throw away a file.
void ResultCache::trim() const {
  std::vector<Kept> packs = packs_in(folder_);
  std::uint64_t bytes = 0;
  for (const Kept& pack : packs) bytes += pack.bytes;
  if (bytes <= most_bytes_) return;
  std::ranges::sort(packs, {}, &Kept::used);
  for (const Kept& pack : packs) {
    if (bytes <= most_bytes_ / 10 * 9) return;
    std::error_code error;
    if (fs::remove(pack.path, error)) bytes -= pack.bytes;
  }
}

}  // namespace rad::batch
