#include "readers/file_bytes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace rad::readers {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 16;

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

std::string reason_of(int error) { return std::generic_category().message(error); }

std::string over_limit(std::uint64_t limit) {
  return "it is larger than the limit of " + std::to_string(limit) + " bytes";
}

}  // namespace

FileBytes::~FileBytes() {
  if (mapping_ != nullptr) ::munmap(mapping_, bytes_.size());
}

std::string FileBytes::open(const std::filesystem::path& path, std::uint64_t limit, FileKind kind) {
  // Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
  const Descriptor file(path, kind == FileKind::Regular ? O_RDONLY | O_NONBLOCK : O_RDONLY);
  if (file.number() < 0) return reason_of(errno);
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) return reason_of(errno);
  if (S_ISDIR(status.st_mode)) return "it is a folder";
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    const auto size = static_cast<std::uint64_t>(status.st_size);
    return size > limit ? over_limit(limit) : map(file.number(), size);
  }
  if (S_ISREG(status.st_mode) || kind == FileKind::RegularOrStream) return read_stream(file.number(), limit);
  return "it is not a regular file";
}

std::string FileBytes::map(int descriptor, std::uint64_t size) {
  void* const mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor, 0);
  if (mapping == MAP_FAILED) return read_stream(descriptor, size);
  mapping_ = mapping;
  bytes_ = {static_cast<const char*>(mapping), size};
  return {};
}

// Files of the kernel state no size, so that a regular file of size zero comes here as well.
std::string FileBytes::read_stream(int descriptor, std::uint64_t limit) {
  std::array<char, kChunkBytes> chunk;
  while (true) {
    const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return reason_of(errno);
    if (count == 0) break;
    if (owned_.size() + static_cast<std::uint64_t>(count) > limit) return over_limit(limit);
    owned_.append(chunk.data(), static_cast<std::size_t>(count));
  }
  bytes_ = owned_;
  return {};
}

}  // namespace rad::readers
