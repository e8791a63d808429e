#include "cli/inputs.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "readers/reader.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

bool is_model(const fs::path& path) {
  std::string name = path.filename().string();
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  // A suffix may have two parts, as .city.json has.
  return std::ranges::any_of(readers::model_suffixes(), [&](std::string_view suffix) { return name.ends_with(suffix); });
}

std::string suffixes_looked_for() {
  std::string text;
  for (const std::string_view suffix : readers::model_suffixes())
    text += (text.empty() ? " (" : " ") + std::string(suffix);
  return text + ")";
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

using Excluded = std::function<bool(const fs::path&)>;

/// Turns paths below a folder into absolute ones, faster than the file system library does.
class AbsolutePaths {
 public:
  explicit AbsolutePaths(const fs::path& folder) : folder_(without_end(folder.native())) {
    std::error_code error;
    base_ = without_end(fs::absolute(folder, error).lexically_normal().native());
  }

  /// `path` as an iterator over the folder gives it.
  [[nodiscard]] fs::path of(const fs::path& path) const {
    std::string_view rest = std::string_view(path.native()).substr(folder_.size());
    rest.remove_prefix(std::min(rest.find_first_not_of('/'), rest.size()));
    return base_ + "/" + std::string(rest);
  }

 private:
  static std::string without_end(std::string text) {
    while (!text.empty() && text.back() == '/') text.pop_back();
    return text;
  }

  std::string folder_;
  std::string base_;
};

/// Appends the models below `folder` in order. Returns what went wrong.
std::string search(const fs::path& folder, const Excluded& is_excluded, std::vector<std::string>& found) {
  std::error_code error;
  const AbsolutePaths absolute(folder);
  fs::path at = folder;
  fs::recursive_directory_iterator entry(folder, error);
  std::vector<std::string> here;
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code unknown;
    at = entry->path();
    if (is_hidden(at) || is_excluded(absolute.of(at))) {
      if (entry->is_directory(unknown)) entry.disable_recursion_pending();
      continue;
    }
    if (entry->is_regular_file(unknown) && is_model(at)) here.push_back(at.generic_string());
  }
  if (error) return at.string() + ": cannot be searched: " + error.message() + " (--exclude passes it over)";
  std::sort(here.begin(), here.end());
  found.insert(found.end(), here.begin(), here.end());
  return {};
}

std::string collect(const std::string& path, const Excluded& is_excluded, std::vector<std::string>& found) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (path == "-") return "reading a model from standard input is not supported; name a file";
  if (!fs::exists(status)) return path + ": no such file or folder";
  if (!fs::is_directory(status)) {
    found.push_back(path);
    return {};
  }
  const std::size_t before = found.size();
  std::string problem = search(path, is_excluded, found);
  if (problem.empty() && found.size() == before)
    problem = path + ": no model files in this folder" + suffixes_looked_for();
  return problem;
}

}  // namespace

InputFiles collect_inputs(std::span<const std::string> paths, const Excluded& is_excluded) {
  InputFiles inputs;
  std::vector<std::string> found;
  for (const std::string& path : paths) {
    inputs.problem = collect(path, is_excluded, found);
    if (!inputs.problem.empty()) return inputs;
  }
  std::set<std::string> seen;
  for (std::string& path : found) {
    if (seen.insert(path).second) inputs.paths.push_back(std::move(path));
  }
  return inputs;
}

}  // namespace rad::cli
