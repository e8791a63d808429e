#include "batch/result_cache.h"

#include <algorithm>
#include <utility>

#include "batch/digest.h"
#include "readers/file_bytes.h"
#include "writers/whole_file.h"

namespace rad::batch {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead = "radlint result 1\n";
constexpr std::string_view kAbsent = "-";
constexpr std::string_view kSuffix = ".result";

std::string state_of(const fs::path& companion) { return digest_of_file(companion).value_or(std::string(kAbsent)); }

// head, digest of what follows, line end, one line "state path" for each companion, an empty line, the result.
std::string entry_of(std::string_view result, const std::vector<fs::path>& companions) {
  std::string body;
  for (const fs::path& companion : companions) body += state_of(companion) + " " + companion.string() + "\n";
  body += '\n';
  body += result;
  return std::string(kHead) + digest_of(body) + "\n" + body;
}

std::string_view line_of(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

bool as_it_was(std::string_view line) {
  const std::size_t blank = line.find(' ');
  return blank != std::string_view::npos && state_of(fs::path(line.substr(blank + 1))) == line.substr(0, blank);
}

std::optional<std::string> result_in(std::string_view entry) {
  if (!entry.starts_with(kHead)) return std::nullopt;
  entry.remove_prefix(kHead.size());
  const std::string_view digest = line_of(entry);
  if (digest != digest_of(entry)) return std::nullopt;
  for (std::string_view line = line_of(entry); !line.empty(); line = line_of(entry)) {
    if (!as_it_was(line)) return std::nullopt;
  }
  return std::string(entry);
}

bool has_line_end(const fs::path& path) { return path.string().find('\n') != std::string::npos; }

struct Kept {
  fs::file_time_type used;
  std::uint64_t bytes = 0;
  fs::path path;
};

std::vector<Kept> entries_of(const fs::path& folder) {
  std::vector<Kept> entries;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (entry->path().extension() != kSuffix || !entry->is_regular_file(gone)) continue;
    Kept kept{entry->last_write_time(gone), 0, entry->path()};
    if (!gone) kept.bytes = entry->file_size(gone);
    if (!gone) entries.push_back(std::move(kept));
  }
  return entries;
}

}  // namespace

ResultCache::ResultCache(fs::path folder, std::uint64_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes) {}

fs::path ResultCache::path_of(const std::string& key) const {
  return folder_ / key.substr(0, 2) / (key.substr(2) + std::string(kSuffix));
}

std::optional<std::string> ResultCache::find(const std::string& key) const {
  const fs::path path = path_of(key);
  readers::FileBytes file;
  if (!file.open(path, most_bytes_, readers::FileKind::Regular).empty()) return std::nullopt;
  std::optional<std::string> result = result_in(file.bytes());
  std::error_code unwritable;
  if (result) fs::last_write_time(path, fs::file_time_type::clock::now(), unwritable);
  return result;
}

void ResultCache::keep(const std::string& key, std::string_view result, const std::vector<fs::path>& companions) const {
  if (std::ranges::any_of(companions, has_line_end)) return;
  const fs::path path = path_of(key);
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (!error) static_cast<void>(writers::write_whole_file(path, entry_of(result, companions)));
}

// Down to nine tenths, so that not every run has to throw away one entry.
void ResultCache::trim() const {
  std::vector<Kept> entries = entries_of(folder_);
  std::uint64_t bytes = 0;
  for (const Kept& entry : entries) bytes += entry.bytes;
  if (bytes <= most_bytes_) return;
  std::ranges::sort(entries, {}, &Kept::used);
  for (const Kept& entry : entries) {
    if (bytes <= most_bytes_ / 10 * 9) return;
    std::error_code error;
    if (fs::remove(entry.path, error)) bytes -= entry.bytes;
  }
}

}  // namespace rad::batch
