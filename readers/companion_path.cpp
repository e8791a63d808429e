#include "readers/companion_path.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace rad::readers {
namespace {

bool lies_below(const std::filesystem::path& path, const std::filesystem::path& directory) {
  return std::mismatch(directory.begin(), directory.end(), path.begin(), path.end()).first == directory.end();
}

// Whether, after links are followed, the path still lies below the folder. A folder that does not exist holds nothing
// that a link could lead out of.
bool links_stay_below(const std::filesystem::path& path, const std::filesystem::path& directory) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::canonical(directory, error);
  if (error) return true;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  return !error && lies_below(target, folder);
}

}  // namespace

std::optional<std::filesystem::path> companion_path(const std::filesystem::path& directory, std::string_view name) {
  if (name.empty() || name.find_first_of(std::string_view(":\0", 2)) != std::string_view::npos) return std::nullopt;
  std::string portable(name);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  const std::filesystem::path relative = std::filesystem::path(portable).lexically_normal();
  if (relative.is_absolute() || relative.empty() || *relative.begin() == "..") return std::nullopt;
  const std::filesystem::path folder = directory.empty() ? std::filesystem::path(".") : directory;
  const std::filesystem::path path = folder / relative;
  if (!links_stay_below(path, folder)) return std::nullopt;
  return path;
}

}  // namespace rad::readers
