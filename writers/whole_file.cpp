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

std::filesystem::path partial_of(const WholeFile& file) {
  std::filesystem::path partial = file.path;
  partial += ".partial";
  return partial;
}

std::string write_partial(const WholeFile& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file.path, error)) return file.path.string() + ": is a folder";
  std::string trouble = write_bytes(partial_of(file), file.bytes);
  if (!trouble.empty()) std::filesystem::remove(partial_of(file), error);
  return trouble;
}

std::string replace(const WholeFile& file) {
  std::error_code error;
  std::filesystem::rename(partial_of(file), file.path, error);
  return error ? file.path.string() + ": cannot be replaced: " + error.message() : std::string();
}

}  // namespace

std::string write_whole_files(std::span<const WholeFile> files) {
  std::string trouble;
  std::size_t written = 0, renamed = 0;
  while (written < files.size() && trouble.empty()) {
    trouble = write_partial(files[written]);
    if (trouble.empty()) ++written;
  }
  while (renamed < written && trouble.empty()) trouble = replace(files[renamed++]);
  std::error_code error;
  if (!trouble.empty()) {
    for (const WholeFile& file : files.first(written)) std::filesystem::remove(partial_of(file), error);
  }
  return trouble;
}

std::string write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
  const WholeFile file{path, bytes};
  return write_whole_files({&file, 1});
}

}  // namespace rad::writers
