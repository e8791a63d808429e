#include "report/atlas_json.h"

#include <numbers>

#include "report/json_parts.h"

namespace rad::report {
namespace {

Json head_json(const AtlasRecord& record) {
  const bool irradiance = record.options.stored == bake::StoredQuantity::Irradiance;
  Json json;
  json["schemaVersion"] = kAtlasSchemaVersion;
  json["tool"] = tool_json("radfix");
  json["model"] = record.model;
  json["bake"] = record.options.look == scene::LightMapLook::Unlit ? "lightmap" : "emissive";
  json["quantity"] = irradiance ? "irradiance" : "radiant exitance";
  json["units"] = "W/m2";
  json["precision"] = record.precision == bake::ExrPrecision::Half ? "half" : "float";
  json["exposure"] = record.options.exposure;
  json["curve"] = scene::name(record.options.curve);
  json["clampedShare"] = record.clamped_share;
  json["texel"] = record.atlas.texel;
  json["gutter"] = bake::kGutter;
  return json;
}

Json page_json(const AtlasRecord& record, std::size_t page) {
  return {{"exr", record.exr_pages[page]},
          {"png", record.png_pages[page]},
          {"width", record.atlas.pages[page].width},
          {"height", record.atlas.pages[page].height}};
}

Json material_json(const AtlasRecord& record, std::size_t id) { return {{"name", record.scene.materials[id].name}}; }

Json pair_json(const glm::dvec2& pair) { return Json::array({pair.x, pair.y}); }

Json chart_json(const AtlasRecord& record, std::size_t index, const mesh::DisplayFace& face) {
  const bake::LightChart& chart = record.atlas.charts[index];
  const bake::ChartPlace& place = record.atlas.places[index];
  return {{"page", place.page},
          {"x", place.x},
          {"y", place.y},
          {"width", place.columns},
          {"height", place.rows},
          {"texel", pair_json(place.texel)},
          {"origin", point_json(chart.origin)},
          {"right", point_json(chart.right)},
          {"down", point_json(chart.down)},
          {"object", record.scene.objects[face.object]},
          {"group", record.scene.groups[face.group]},
          {"material", face.material},
          {"white", record.white[index]},
          {"whiteLuminance", record.white[index] * std::numbers::inv_pi}};
}

// A face of each chart.
std::vector<const mesh::DisplayFace*> faces_of_charts(const AtlasRecord& record) {
  std::vector<const mesh::DisplayFace*> faces(record.atlas.charts.size(), nullptr);
  for (const mesh::DisplayFace& face : record.display.faces) {
    const mesh::DisplayFace*& first = faces[record.atlas.chart_of_patch[face.patch]];
    if (first == nullptr) first = &face;
  }
  return faces;
}

class Lines {
 public:
  explicit Lines(const Json& head) : text_(head.dump(2, ' ', false, Json::error_handler_t::replace)) {
    text_.erase(text_.size() - 2);  // the end of the object, which goes on
  }

  template <typename Item>
  void add(const char* name, std::size_t count, Item&& item) {
    text_ += std::string(",\n  \"") + name + "\": [";
    for (std::size_t i = 0; i < count; ++i) {
      text_ += i == 0 ? "\n    " : ",\n    ";
      text_ += item(i).dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    text_ += "\n  ]";
  }
  std::string take() { return std::move(text_) + "\n}\n"; }

 private:
  std::string text_;
};

}  // namespace

std::string atlas_json(const AtlasRecord& record) {
  Lines lines(head_json(record));
  lines.add("pages", record.atlas.pages.size(), [&](std::size_t page) { return page_json(record, page); });
  lines.add("materials", record.scene.materials.size(), [&](std::size_t id) { return material_json(record, id); });
  const auto faces = faces_of_charts(record);
  lines.add("charts", faces.size(), [&](std::size_t chart) { return chart_json(record, chart, *faces[chart]); });
  return lines.take();
}

}  // namespace rad::report
