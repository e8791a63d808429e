#include "tools/rule_pictures.h"

#include <png.h>

#include <cstdlib>
#include <optional>
#include <vector>

#include "bake/fault_painter.h"
#include "bake/png.h"
#include "readers/reader.h"
#include "validate/lint.h"

namespace rad::tools {
namespace {

namespace fs = std::filesystem;
using scene::Finding;

constexpr std::uint32_t kWidth = 400, kHeight = 260;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

std::optional<fs::path> model_named(const fs::path& folder, const std::string& stem) {
  for (const std::string_view suffix : readers::model_suffixes()) {
    const fs::path path = folder / (stem + std::string(suffix));
    if (fs::exists(path)) return path;
  }
  return std::nullopt;
}

std::vector<Finding> findings_of(const validate::Rule& rule, const readers::ReadResult& read) {
  using validate::Stage;
  for (const Stage stage : {Stage::Model, Stage::Preprocess, Stage::Solve, Stage::Display}) {
    validate::LintOptions options;
    options.rules = {&rule};
    options.stage = stage;
    std::vector<Finding> findings = validate::lint(read.scene, read.issues, options).findings;
    if (!findings.empty()) return findings;
  }
  return {};
}

std::string drawn(const bake::FaultPainter& painter, const bake::Camera& camera,
                  std::span<const bake::DrawnFault> faults) {
  bake::FaultPicture picture;
  picture.width = kWidth;
  picture.height = kHeight;
  picture.camera = camera;
  return bake::png_bytes(painter.picture(picture, faults));
}

}  // namespace

RulePictures rule_pictures(const validate::Rule& rule, const fs::path& folder) {
  const auto fail = model_named(folder, "fail"), pass = model_named(folder, "pass");
  if (!fail || !pass) return {};
  const readers::ReadResult bad = readers::read_file(*fail), good = readers::read_file(*pass);
  const std::vector<Finding> findings = findings_of(rule, bad);
  if (findings.empty() || findings.front().where.places.empty() || good.scene.faces.empty()) return {};
  // From outside where that shows the fault, else through the backs of the walls before it.
  bake::BackFaces backs = bake::BackFaces::Seen;
  const bake::FaultPainter solid(bad.scene, backs);
  bake::Camera camera = solid.whole(findings.front(), kAspect);
  if (!solid.shows(findings.front(), camera)) backs = bake::BackFaces::SeenThrough;
  const bake::FaultPainter painter(bad.scene, backs);
  if (backs == bake::BackFaces::SeenThrough) camera = painter.whole(findings.front(), kAspect);
  std::vector<bake::DrawnFault> faults;
  for (const Finding& finding : findings) faults.push_back(bake::drawn(finding));
  return {drawn(painter, camera, faults), drawn(bake::FaultPainter(good.scene, backs), camera, {})};
}

namespace {

struct Pixels {
  std::uint32_t width = 0, height = 0;
  std::vector<png_byte> codes;
};

std::optional<Pixels> pixels_of(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0) return std::nullopt;
  image.format = PNG_FORMAT_RGB;
  Pixels pixels{image.width, image.height, std::vector<png_byte>(PNG_IMAGE_SIZE(image))};
  if (png_image_finish_read(&image, nullptr, pixels.codes.data(), 0, nullptr) == 0) return std::nullopt;
  return pixels;
}

}  // namespace

bool shows_the_same(const std::string& png, const std::string& other) {
  if (png == other) return true;
  const auto a = pixels_of(png), b = pixels_of(other);
  if (!a || !b || a->width != b->width || a->height != b->height) return false;
  // A ray that meets the other of two faces at an edge changes a ninth of a pixel.
  constexpr int kRoundedCodes = 2;
  constexpr std::size_t kLeastShare = 500;  ///< one code value in that many may differ by more
  std::size_t different = 0;
  for (std::size_t i = 0; i < a->codes.size(); ++i) {
    if (std::abs(a->codes[i] - b->codes[i]) > kRoundedCodes) ++different;
  }
  return different * kLeastShare <= a->codes.size();
}

}  // namespace rad::tools
