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

/// Appends the models below `folder` in order. Returns what went wrong.
std::string search(const fs::path& folder, const Excluded& is_excluded, std::vector<std::string>& found) {
  std::error_code error;
  const fs::path base = fs::absolute(folder, error).lexically_normal();
  fs::path at = folder;
  fs::recursive_directory_iterator entry(folder, error);
  std::vector<std::string> here;
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code unknown;
    at = entry->path();
    if (is_hidden(at) || is_excluded((base / at.lexically_relative(folder)).lexically_normal())) {
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
