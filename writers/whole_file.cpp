#include "writers/whole_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace rad::writers {
namespace {

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string problem(const std::filesystem::path& path, const char* what) {
  return path.string() + ": " + what + ": " + std::strerror(errno);
}

std::string write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "wb"));
  if (!file) return problem(path, "cannot be opened for writing");
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() || std::fflush(file.get()) != 0) {
    return problem(path, "cannot be written");
  }
  return std::fclose(file.release()) == 0 ? std::string() : problem(path, "cannot be closed");
}

}  // namespace

std::string write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path partial = path;
  partial += ".partial";
  std::string trouble = write_bytes(partial, bytes);
  std::error_code error;
  if (trouble.empty()) {
    std::filesystem::rename(partial, path, error);
    if (error) trouble = path.string() + ": cannot be replaced: " + error.message();
  }
  if (!trouble.empty()) std::filesystem::remove(partial, error);
  return trouble;
}

}  // namespace rad::writers
