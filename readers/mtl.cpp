#include "readers/mtl.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "readers/mtl_optics.h"
#include "readers/mtl_texture.h"
#include "readers/text_cursor.h"

namespace rad::readers {
namespace {

using scene::Material;
using scene::ReadIssueKind;

class MtlReader {
 public:
  MtlReader(std::string_view bytes, const std::string& path, scene::ReadIssues& issues)
      : cursor_(bytes), path_(path), issues_(issues) {}

  std::vector<Material> run() {
    while (cursor_.next_line()) read_statement(cursor_.next_token());
    for (std::size_t i = 0; i < materials_.size(); ++i) optics_[i].settle(materials_[i]);
    for (Material& material : materials_) {
      const scene::dvec3& colour = material.reflectance;
      if (material.texture && material.reflectance_stated) material.texture->factor = {colour.x, colour.y, colour.z};
    }
    return std::move(materials_);
  }

 private:
  void read_statement(std::string_view keyword) {
    if (keyword == "newmtl") {
      materials_.emplace_back().name = cursor_.rest();
      optics_.emplace_back();
    } else if (keyword == "Kd") {
      const auto colour = read_colour(keyword);
      if (!colour) return;
      materials_.back().reflectance = *colour;
      materials_.back().reflectance_stated = true;
    } else if (keyword == "Ke") {
      const auto colour = read_colour(keyword);
      if (colour) materials_.back().emission = *colour;
    } else if (keyword == "map_Kd" && !materials_.empty()) {
      materials_.back().texture = mtl_texture(cursor_);
    } else if (!materials_.empty()) {
      optics_.back().read(keyword, cursor_);
    }
  }

  // Three numbers, or one that stands for all three.
  std::optional<scene::dvec3> read_colour(std::string_view keyword) {
    if (materials_.empty()) return refuse(std::string(keyword) + " stands before the first newmtl");
    TextCursor ahead = cursor_;
    const std::string_view model = ahead.next_token();
    if (model == "spectral" || model == "xyz") {
      issues_.add_unsupported(std::string(keyword) + " " + std::string(model) + " in a material library", place());
      return std::nullopt;
    }
    std::array<double, 3> parts{};
    std::size_t count = 0;
    while (count < 3) {
      const TextCursor::Token token = cursor_.next_number(parts[count]);
      if (token == TextCursor::Token::Absent) break;
      if (token == TextCursor::Token::Bad) return refuse(in_quotes(cursor_.bad_token()) + " is not a number");
      if (!std::isfinite(parts[count])) return refuse(std::string(keyword) + " is not finite");
      ++count;
    }
    if (count == 1) return scene::dvec3(parts[0]);
    if (count == 3) return scene::dvec3(parts[0], parts[1], parts[2]);
    return refuse(std::string(keyword) + " takes one number or three, not " + std::to_string(count));
  }

  std::nullopt_t refuse(std::string what) {
    issues_.add({ReadIssueKind::ParseError, std::move(what), place(), 1});
    return std::nullopt;
  }

  [[nodiscard]] scene::IssuePlace place() const {
    scene::IssuePlace place;
    place.file = path_;
    place.line = cursor_.line();
    return place;
  }

  TextCursor cursor_;
  const std::string& path_;
  scene::ReadIssues& issues_;
  std::vector<Material> materials_;
  std::vector<MtlOptics> optics_;  ///< of each material
};

}  // namespace

std::vector<Material> read_mtl(std::string_view bytes, const std::string& path, scene::ReadIssues& issues) {
  if (bytes.find('\0') != std::string_view::npos) {
    scene::IssuePlace place;
    place.file = path;
    place.byte_offset = bytes.find('\0');
    issues.add({ReadIssueKind::ParseError, "a material library is text, this file is not", std::move(place), 1});
    return {};
  }
  return MtlReader(bytes, path, issues).run();
}

}  // namespace rad::readers
