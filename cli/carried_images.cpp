#include "cli/carried_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "cli/options.h"
#include "writers/registry.h"
#include "writers/whole_file.h"

namespace rad::cli {
namespace {

namespace fs = std::filesystem;
using scene::Image;

/// An image to be written beside the result.
struct ImageBeside {
  fs::path path;
  std::string bytes;
};

constexpr std::array<std::array<std::string_view, 2>, 6> kMediaTypes{{{".png", "image/png"},
                                                                      {".jpg", "image/jpeg"},
                                                                      {".jpeg", "image/jpeg"},
                                                                      {".webp", "image/webp"},
                                                                      {".ktx2", "image/ktx2"},
                                                                      {".avif", "image/avif"}}};
// Of one image that is read: as large as any picture of 16 384 pixels a side.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30U;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string_view media_type_of(const fs::path& file) {
  const std::string suffix = lower(file.extension().string());
  const auto found = std::ranges::find(kMediaTypes, suffix, [](const auto& row) { return row[0]; });
  return found == kMediaTypes.end() ? std::string_view() : (*found)[1];
}

std::string suffix_of(const Image& image) {
  const auto found = std::ranges::find(kMediaTypes, image.media_type, [](const auto& row) { return row[1]; });
  return found == kMediaTypes.end() ? std::string() : std::string((*found)[0]);
}

std::optional<std::string> bytes_of(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > kMostBytes || error) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  return stream.good() || stream.eof() ? std::optional(std::move(bytes)) : std::nullopt;
}

// Relative, with '/'; nothing for what is named by a drive, a root or a scheme.
std::optional<fs::path> relative_path(std::string text) {
  std::ranges::replace(text, '\\', '/');
  if (text.empty() || text.front() == '/' || text.find(':') != std::string::npos) return std::nullopt;
  return fs::path(text).lexically_normal();
}

class Carrying {
 public:
  Carrying(const std::string& input, const std::string& output)
      : from_(fs::path(input).parent_path()), output_(output) {
    embeds_ = lower(output).ends_with(".glb");
    keeps_embedded_ = embeds_ || lower(output).ends_with(".gltf");
    std::error_code error;
    const auto folder = [&](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path, error), error); };
    same_folder_ = folder(from_) == folder(output_.parent_path());
  }

  std::shared_ptr<const Image> carried(const std::shared_ptr<const Image>& image) {
    const auto [known, is_new] = done_.try_emplace(image, image);
    if (is_new) known->second = image->embedded() ? out_of_the_file(image) : beside_the_file(image);
    return known->second;
  }

  // Creates folders below that of the output.
  [[nodiscard]] std::string write() const {
    if (!problem_.empty()) return problem_;
    std::vector<writers::WholeFile> files;
    for (const ImageBeside& file : files_) {
      std::error_code error;
      if (!file.path.parent_path().empty()) fs::create_directories(file.path.parent_path(), error);
      if (error) return file.path.parent_path().string() + ": " + error.message();
      files.push_back({file.path, file.bytes});
    }
    return writers::write_whole_files(files);
  }

 private:
  std::shared_ptr<const Image> out_of_the_file(const std::shared_ptr<const Image>& image) {
    const std::string suffix = suffix_of(*image);
    if (keeps_embedded_ || suffix.empty()) return image;
    fs::path name = output_.stem();
    name += fmt::format(".image-{}{}", ++extracted_, suffix);
    return written(name, image->bytes);
  }

  std::shared_ptr<const Image> beside_the_file(const std::shared_ptr<const Image>& image) {
    const auto path = relative_path(image->path);
    if (!path || (same_folder_ && !embeds_)) return image;
    std::optional<std::string> bytes = bytes_of(from_ / *path);
    if (!bytes) return image;
    const std::string_view media_type = media_type_of(*path);
    if (embeds_) {
      if (media_type.empty()) return image;
      return std::make_shared<Image>(Image{{}, path->filename().string(), std::string(media_type), std::move(*bytes)});
    }
    return written(*path->begin() == ".." ? path->filename() : *path, std::move(*bytes));
  }

  std::shared_ptr<const Image> written(const fs::path& name, std::string bytes) {
    const fs::path place = output_.parent_path() / name;
    std::error_code error;
    if (fs::exists(place, error) && bytes_of(place) != bytes) {
      problem_ = place.string() + ": is there already and is another image; move it away first";
    }
    files_.push_back({place, std::move(bytes)});
    return std::make_shared<Image>(Image{name.generic_string(), {}, {}, {}});
  }

  fs::path from_;
  fs::path output_;
  bool embeds_ = false;
  bool keeps_embedded_ = false;
  bool same_folder_ = false;
  int extracted_ = 0;
  std::map<std::shared_ptr<const Image>, std::shared_ptr<const Image>> done_;
  std::string problem_;
  std::vector<ImageBeside> files_;
};

}  // namespace

std::string bring_images(scene::Scene& scene, const std::string& input, const std::string& output) {
  const writers::Writer* const writer = writers::writer_for(output);
  if (writer == nullptr || !writer->holds.images || input == kStream) return {};
  Carrying carrying(input, output);
  for (scene::Material& material : scene.materials) {
    if (material.texture) material.texture->image = carrying.carried(material.texture->image);
  }
  return carrying.write();
}

}  // namespace rad::cli
