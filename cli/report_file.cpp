#include "cli/report_file.h"

#include <filesystem>
#include <fstream>

#include "writers/whole_file.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

std::string write_through(const fs::path& path, std::string_view text) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  return stream.flush() ? std::string() : path.string() + ": cannot be written";
}

}  // namespace

std::string write_report_file(const std::string& path, std::string_view text) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return path + ": is a folder";
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_through(path, text);
  // The file that a link leads to is replaced, not the link.
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : fs::path(path);
  return writers::write_whole_file(target, text);
}

}  // namespace rad::cli
