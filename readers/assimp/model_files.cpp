#include "readers/assimp/model_files.h"

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cstring>
#include <memory>
#include <system_error>

#include "readers/companion_path.h"
#include "readers/file_bytes.h"

namespace rad::readers::assimp {
namespace {

/// Bytes in memory that cannot be written.
class ByteStream : public Assimp::IOStream {
 public:
  explicit ByteStream(std::string_view bytes) : bytes_(bytes) {}
  explicit ByteStream(std::unique_ptr<FileBytes> file) : file_(std::move(file)), bytes_(file_->bytes()) {}

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
    std::memcpy(buffer, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }

  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }

  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    // Offsets back from the current place or the end arrive as large unsigned numbers.
    const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    const std::size_t target = base + offset;
    if (target > bytes_.size()) return aiReturn_FAILURE;
    at_ = target;
    return aiReturn_SUCCESS;
  }

  std::size_t Tell() const override { return at_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::unique_ptr<FileBytes> file_;
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace

bool ModelFiles::Exists(const char* path) const {
  if (path == name_) return true;
  const auto companion = companion_path(input_.directory, path);
  std::error_code error;
  return companion && std::filesystem::is_regular_file(*companion, error);
}

Assimp::IOStream* ModelFiles::Open(const char* path, const char* mode) {
  if (std::strchr(mode, 'w') != nullptr) return nullptr;
  if (path == name_) return new ByteStream(input_.bytes);
  const auto companion = companion_path(input_.directory, path);
  if (!companion) return nullptr;
  if (input_.companions != nullptr) input_.companions->push_back(*companion);
  auto file = std::make_unique<FileBytes>();
  if (!file->open(*companion, input_.limits.file_bytes, FileKind::Regular).empty()) return nullptr;
  return new ByteStream(std::move(file));
}

void ModelFiles::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace rad::readers::assimp
