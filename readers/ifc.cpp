// IFC through a helper on Node.js (web/ifc/ifc_faces.mjs), which cuts openings and divides solids into triangles.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <system_error>

#include "readers/child_output.h"
#include "readers/components.h"
#include "readers/ifc_helper.h"
#include "readers/instance_lines.h"
#include "readers/json_view.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"
#include "scene/drawing_colour.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader ifc_reader;
std::string ifc_version();

std::filesystem::path ifc_helper() {
  std::error_code error;
  const char* const named = std::getenv("RAD_IFC_HELPER");
  for (const char* candidate : {named, RAD_IFC_HELPER_INSTALLED, RAD_IFC_HELPER_SOURCE}) {
    if (candidate != nullptr && std::filesystem::is_regular_file(candidate, error)) return candidate;
  }
  return {};
}

namespace ifc {
namespace {

namespace fs = std::filesystem;
using scene::ReadIssueKind;

constexpr std::string_view kMark = "ISO-10303-21;";
constexpr std::string_view kRemedy = "; install Node.js and the helper (npm ci in web/), or export glTF";
constexpr std::uint64_t kMostBytes = 4ull << 30;  ///< of what the helper says
constexpr std::chrono::seconds kPatience{1800};
constexpr std::size_t kLongestName = 255;

class IfcReader {
 public:
  explicit IfcReader(const Input& input) : input_(input), builder_(input.path, "ifc") {
    builder_.add_section({input.path, {}, scene::RecordKind::Line});
    scene::Scene& scene = builder_.scene();
    scene.metres_per_unit = 1;
    scene.up = scene::UpAxis::Z;
    scene.single_precision = true;
    scene.splits_vertices = true;
    scene.triangles_only = true;
  }

  ReadResult run() {
    const fs::path helper = ifc_helper();
    std::error_code error;
    if (helper.empty()) {
      refuse("IFC is read through a helper that is not there" + std::string(kRemedy));
    } else if (!fs::is_regular_file(input_.path, error)) {
      refuse("IFC is read from files only, not from a stream");
    } else {
      read_through(helper);
    }
    return {builder_.take(), std::move(issues_)};
  }

 private:
  void refuse(std::string what) { issues_.add({ReadIssueKind::ParseError, std::move(what), {}, 1}); }

  void read_through(const fs::path& helper) {
    const ChildOutput said =
        output_of({"node", helper.string(), fs::absolute(input_.path).string()}, {}, kMostBytes, kPatience);
    if (!said.problem.empty()) return refuse("IFC is read with Node.js: " + said.problem + std::string(kRemedy));
    lines_ = lines_of_instances(input_.bytes);
    std::string_view text = said.text;
    while (!text.empty() && !full_) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      if (end > 0) read_line(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (!ended_ && !full_ && !failed_) refuse("the helper for IFC ended before its report did" + std::string(kRemedy));
  }

  void read_line(std::string_view line) {
    const auto json = parse_json_object(line, 0, "a line of the helper", issues_);
    if (!json) return;
    const JsonView view(*json, "", issues_);
    if (view.has("error")) {
      failed_ = true;
      return refuse("the file cannot be read: " + in_quotes(view.text("error")));
    }
    ended_ |= view.has("end");
    if (view.has("vertices")) read_part(view);
  }

  void read_part(const JsonView& part) {
    const auto id = part.whole("id").value_or(0);
    const auto found = lines_.find(id);
    const std::uint64_t line = found == lines_.end() ? 0 : found->second;
    const std::string name = part.text("name").substr(0, kLongestName);
    const std::string type = part.text("type").substr(0, kLongestName);
    builder_.use_object(builder_.object(name.empty() ? part.text("guid") : name));
    builder_.use_group(builder_.group(part.text("storey")));
    builder_.use_entity(builder_.add_entity(type + " " + part.text("guid")));
    builder_.use_material(material_of(part, type));
    add_faces(part, line);
  }

  // A material may be shown in more than one colour: each is a material of its own.
  scene::MaterialId material_of(const JsonView& part, const std::string& type) {
    const auto colour = part.numbers("colour", 4);
    const std::string material = part.text("material").substr(0, kLongestName);
    const std::string base = material.empty() ? type : material;
    if (!colour) return builder_.material(base);
    const scene::dvec3 reflectance = scene::reflectance_of_srgb({(*colour)[0], (*colour)[1], (*colour)[2]});
    const auto key = std::tuple(base, (*colour)[0], (*colour)[1], (*colour)[2]);
    const auto [entry, fresh] = materials_.try_emplace(key);
    if (!fresh) return entry->second;
    const std::uint64_t use = ++uses_of_name_[base];
    entry->second = builder_.material(use == 1 ? base : base + " (" + std::to_string(use) + ")");
    scene::Material& made = builder_.material_at(entry->second);
    made.reflectance = reflectance;
    made.reflectance_stated = true;
    if ((*colour)[3] < 1) issues_.add_unsupported("transparency of materials", {});
    return entry->second;
  }

  void add_faces(const JsonView& part, std::uint64_t line) {
    const std::size_t numbers = part.length("vertices");
    std::string why = limit_before_vertices(builder_.scene(), numbers / 3, input_.limits);
    const std::vector<std::uint64_t> corners = part.wholes("triangles");
    if (why.empty()) why = limit_before_face(builder_.scene(), corners.size(), input_.limits);
    if (!why.empty()) {
      full_ = true;
      return refuse(std::move(why));
    }
    const auto points = part.numbers("vertices", numbers);
    if (!points) return;
    const auto first = static_cast<scene::VertexId>(builder_.vertex_count());
    for (std::size_t i = 0; i + 2 < numbers; i += 3) {
      builder_.add_vertex({(*points)[i], (*points)[i + 1], (*points)[i + 2]}, line);
    }
    const std::size_t count = builder_.vertex_count() - first;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      if (std::max({corners[i], corners[i + 1], corners[i + 2]}) >= count) continue;
      const auto vertex = [&](std::size_t corner) { return first + static_cast<scene::VertexId>(corners[corner]); };
      builder_.add_face(std::array{vertex(i), vertex(i + 1), vertex(i + 2)}, line);
    }
  }

  const Input& input_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  std::map<std::uint64_t, std::uint64_t> lines_;
  std::map<std::tuple<std::string, double, double, double>, scene::MaterialId> materials_;
  std::map<std::string, std::uint64_t> uses_of_name_;
  bool ended_ = false;
  bool failed_ = false;
  bool full_ = false;
};

bool sniff(std::string_view head) {
  return head.starts_with(kMark) && head.find("FILE_SCHEMA") != std::string_view::npos &&
         (head.find("'IFC") != std::string_view::npos || head.find("\"IFC") != std::string_view::npos);
}

ReadResult read(const Input& input) { return IfcReader(input).run(); }

}  // namespace
}  // namespace ifc

std::string ifc_version() { return ifc_helper().empty() ? std::string() : "on Node.js"; }

const Reader ifc_reader{"ifc", kIfcSuffixes, ifc::sniff, ifc::read};

}  // namespace rad::readers
