#include "config/path_glob.h"

#include <fnmatch.h>

#include <algorithm>
#include <span>
#include <vector>

namespace rad::config {

namespace {

using Names = std::vector<std::string>;

Names names_of(std::string_view path) {
  Names names;
  while (!path.empty()) {
    const std::size_t slash = path.find('/');
    const std::string_view name = path.substr(0, slash);
    if (!name.empty() && name != ".") names.emplace_back(name);
    path.remove_prefix(slash == std::string_view::npos ? path.size() : slash + 1);
  }
  return names;
}

bool name_matches(const std::string& glob, const std::string& name) {
  return fnmatch(glob.c_str(), name.c_str(), 0) == 0;
}

// Goes back to the last `**` only: an earlier one could take no more than it.
bool names_match(std::span<const std::string> globs, std::span<const std::string> names) {
  std::size_t glob = 0, name = 0, after_stars = SIZE_MAX, retry = 0;
  while (name < names.size()) {
    if (glob < globs.size() && globs[glob] == "**") {
      after_stars = ++glob;
      retry = name;
    } else if (glob < globs.size() && name_matches(globs[glob], names[name])) {
      ++glob;
      ++name;
    } else if (after_stars != SIZE_MAX) {
      glob = after_stars;
      name = ++retry;
    } else {
      return false;
    }
  }
  return std::all_of(globs.begin() + static_cast<std::ptrdiff_t>(glob), globs.end(),
                     [](const std::string& rest) { return rest == "**"; });
}

}  // namespace

bool path_matches(std::string_view glob, std::string_view path) { return names_match(names_of(glob), names_of(path)); }

bool PathPattern::covers(const std::filesystem::path& path) const {
  const std::string relative = path.lexically_relative(base).generic_string();
  if (relative.empty() || relative == ".." || relative.starts_with("../")) return false;
  const Names globs = names_of(glob);
  const Names names = names_of(relative);
  if (glob.find('/') == std::string::npos && globs.size() == 1) {
    return std::ranges::any_of(names, [&](const std::string& name) { return name_matches(glob, name); });
  }
  for (std::size_t length = 1; length <= names.size(); ++length) {
    if (names_match(globs, std::span(names).first(length))) return true;
  }
  return false;
}

}  // namespace rad::config
