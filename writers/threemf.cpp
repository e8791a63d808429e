#include "writers/threemf.h"

#include <fmt/format.h>

#include <array>
#include <unordered_map>
#include <vector>

#include "scene/drawing_colour.h"
#include "writers/face_triangles.h"
#include "writers/head_comments.h"
#include "writers/text_line.h"
#include "writers/whole_file.h"
#include "writers/zip.h"

namespace rad::writers {
namespace {

constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";
constexpr std::string_view kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";
constexpr std::uint64_t kMaterialsId = 1;
constexpr std::uint64_t kMostBytes = 0xFFFFFFFF;

struct Unit {
  double metres;
  std::string_view name;
};
constexpr std::array<Unit, 6> kUnits = {
    {{1e-6, "micron"}, {0.001, "millimeter"}, {0.01, "centimeter"}, {0.0254, "inch"}, {0.3048, "foot"}, {1, "meter"}}};

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : one_line(text)) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += c;
    }
  }
  return out;
}

std::string_view unit_name(const scene::Scene& scene) {
  for (const Unit& unit : kUnits) {
    if (scene.metres_per_unit == unit.metres) return unit.name;
  }
  return "meter";
}

// To metres where 3MF has no name for the unit; Y up is turned to Z up, as 3MF has it.
std::string build_transform(const scene::Scene& scene) {
  const double scale = unit_name(scene) == "meter" ? scene.metres_per_unit.value_or(1) : 1;
  const bool turned = scene.up == scene::UpAxis::Y;
  if (scale == 1 && !turned) return {};
  if (!turned) return fmt::format(" transform=\"{0} 0 0 0 {0} 0 0 0 {0} 0 0 0\"", scale);
  return fmt::format(" transform=\"{0} 0 0 0 0 {0} 0 -{0} 0 0 0 0\"", scale);
}

class ModelText {
 public:
  explicit ModelText(const Output& output) : output_(output), scene_(output.scene) {}

  /// Why there is none; empty where text() is good.
  std::string write() {
    text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    for (const std::string& comment : head_comments(output_)) append_comment(comment);
    text_ += fmt::format(
        "<model unit=\"{}\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
        "<resources>\n",
        unit_name(scene_));
    append_materials();
    const std::string transform = build_transform(scene_);
    std::string build;
    std::vector<std::vector<scene::FaceId>> faces(scene_.objects.size());
    for (scene::FaceId id = 0; id < scene_.faces.size(); ++id) faces[scene_.faces[id].object].push_back(id);
    for (scene::ObjectId object = 0; object < scene_.objects.size(); ++object) {
      bool any = false;
      if (std::string problem = append_object(object, faces[object], any); !problem.empty()) return problem;
      if (any) build += fmt::format("<item objectid=\"{}\"{}/>\n", object_id(object), transform);
    }
    text_ += "</resources>\n<build>\n" + build + "</build>\n</model>\n";
    return {};
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  [[nodiscard]] static std::uint64_t object_id(scene::ObjectId object) {
    return std::uint64_t{object} + kMaterialsId + 1;
  }

  // Two hyphens would end a comment of XML.
  void append_comment(std::string comment) {
    for (std::size_t at = comment.find("--"); at != std::string::npos; at = comment.find("--"))
      comment.replace(at, 2, "- ");
    text_ += "<!-- " + comment + " -->\n";
  }

  void append_materials() {
    text_ += fmt::format("<basematerials id=\"{}\">\n", kMaterialsId);
    for (const scene::Material& material : scene_.materials) {
      text_ += fmt::format("<base name=\"{}\" displaycolor=\"#{:06X}\"/>\n",
                           material.name.empty() ? "unnamed" : escaped(material.name),
                           scene::colour_of_reflectance(material.reflectance));
    }
    text_ += "</basematerials>\n";
  }

  std::string append_object(scene::ObjectId object, const std::vector<scene::FaceId>& faces, bool& any) {
    std::vector<scene::VertexId> vertices;
    std::unordered_map<scene::VertexId, std::uint32_t> numbers;
    std::string triangles;
    for (const scene::FaceId id : faces) {
      const scene::Face& face = scene_.faces[id];
      const auto split = triangles_of(scene_, face);
      if (!split) return unsplit_face(id);
      for (const Triangle& triangle : *split) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
          const scene::VertexId vertex = scene_.corners[triangle[i]];
          const auto [entry, fresh] = numbers.try_emplace(vertex, static_cast<std::uint32_t>(vertices.size()));
          if (fresh) vertices.push_back(vertex);
          corners[i] = entry->second;
        }
        triangles += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\" pid=\"{}\" p1=\"{}\"/>\n", corners[0],
                                 corners[1], corners[2], kMaterialsId, face.material);
      }
    }
    any = !triangles.empty();
    if (any) append_mesh(object, vertices, triangles);
    return {};
  }

  void append_mesh(scene::ObjectId object, const std::vector<scene::VertexId>& vertices, const std::string& triangles) {
    const std::string& name = scene_.objects[object];
    text_ += fmt::format("<object id=\"{}\" type=\"model\" name=\"{}\">\n<mesh>\n<vertices>\n", object_id(object),
                         name.empty() ? "unnamed" : escaped(name));
    for (const scene::VertexId vertex : vertices) {
      const geom::dvec3& at = scene_.vertices[vertex];
      text_ += "<vertex x=\"";
      append_number(text_, at.x);
      text_ += "\" y=\"";
      append_number(text_, at.y);
      text_ += "\" z=\"";
      append_number(text_, at.z);
      text_ += "\"/>\n";
    }
    text_ += "</vertices>\n<triangles>\n" + triangles + "</triangles>\n</mesh>\n</object>\n";
  }

  const Output& output_;
  const scene::Scene& scene_;
  std::string text_;
};

}  // namespace

WriteResult write_3mf(const Output& output, const std::filesystem::path& path) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem)};
  ModelText model(output);
  if (std::string problem = model.write(); !problem.empty()) return {std::move(problem)};
  if (model.text().size() > kMostBytes - (1u << 16)) return {"3MF files are written up to 4 GiB"};
  return {write_whole_file(path, zip_of(std::array<ZipEntry, 3>{{{"[Content_Types].xml", kContentTypes},
                                                                 {"_rels/.rels", kRelationships},
                                                                 {"3D/3dmodel.model", model.text()}}}))};
}

}  // namespace rad::writers
