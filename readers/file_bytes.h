// The bytes of a file, mapped where the system can, read where it cannot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace rad::readers {

/// What may be opened: a companion must be a regular file, so that no pipe or device can hold the reader up.
enum class FileKind : std::uint8_t { Regular, RegularOrStream };

class FileBytes {
 public:
  FileBytes() = default;
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;
  ~FileBytes();

  /// Opens a file of at most `limit` bytes. Gives why it could not, as a clause ("it is a folder"); empty when open.
  std::string open(const std::filesystem::path& path, std::uint64_t limit, FileKind kind);

  /// Valid as long as this object is.
  [[nodiscard]] std::string_view bytes() const { return bytes_; }

 private:
  std::string map(int descriptor, std::uint64_t size);
  std::string read_stream(int descriptor, std::uint64_t limit);

  std::string_view bytes_;
  void* mapping_ = nullptr;
  std::string owned_;
};

}  // namespace rad::readers
