#include "readers/gltf_primitives.h"

#include <algorithm>

#include "readers/gltf_draco.h"

namespace rad::readers::gltf {

namespace {

constexpr std::uint64_t kLineStrip = 3;
constexpr std::uint64_t kTriangles = 4;
constexpr std::uint64_t kTriangleFan = 6;
constexpr std::string_view kDraco = "KHR_draco_mesh_compression";

std::vector<geom::dvec3> as_points(const std::vector<double>& numbers) {
  std::vector<geom::dvec3> points(numbers.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
  return points;
}

std::vector<scene::dvec2> as_pairs(const std::vector<double>& numbers) {
  std::vector<scene::dvec2> pairs(numbers.size() / 2);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {numbers[2 * i], numbers[2 * i + 1]};
  return pairs;
}

// Of extras nothing is demanded: what is of another form is no record.
std::string recorded_group(const JsonView& primitive) {
  const Json* group = primitive.recorded("group");
  return group != nullptr && group->is_string() ? group->get<std::string>() : std::string();
}

class PrimitiveReader {
 public:
  PrimitiveReader(const Document& document, const Buffers& buffers, const Accessors& accessors,
                  std::span<const std::uint64_t> texture_sets, const JsonView& json)
      : document_(document), buffers_(buffers), accessors_(accessors), texture_sets_(texture_sets), json_(json) {}

  std::optional<Primitive> read() {
    const std::uint64_t mode = json_.whole("mode").value_or(kTriangles);
    if (json_.has("targets")) add_unsupported("morph targets");
    if (mode <= kLineStrip) {
      add_unsupported(mode == 0 ? "point primitives" : "line primitives");
      return std::nullopt;
    }
    if (mode > kTriangleFan) {
      report("primitive mode " + std::to_string(mode) + " does not exist");
      return std::nullopt;
    }
    primitive_.pointer = json_.pointer();
    primitive_.material = json_.whole("material");
    primitive_.group = recorded_group(json_);
    const JsonView draco = json_.extension(kDraco);
    if (!(draco ? read_draco(draco) : read_accessors(mode))) return std::nullopt;
    if (!draco) read_attributes();
    drop_misfits();
    return std::move(primitive_);
  }

 private:
  void report(std::string what) const { add_parse_error(document_.issues, std::move(what), json_.pointer()); }

  void add_unsupported(std::string what) const {
    scene::IssuePlace place;
    place.pointer = json_.pointer();
    document_.issues.add_unsupported(std::move(what), std::move(place));
  }

  bool within_limit(std::uint64_t count, std::uint64_t limit, std::string_view of) const {
    if (count <= limit) return true;
    report("the primitive passes the limit of " + std::to_string(limit) + " " + std::string(of));
    return false;
  }

  bool read_accessors(std::uint64_t mode) {
    const auto position = json_.object("attributes").whole("POSITION");
    if (!position) {
      report("the primitive has no POSITION");
      return false;
    }
    const auto shape = accessors_.shape(*position, "VEC3");
    if (!shape || !within_limit(shape->count, document_.input.limits.vertices, "vertices")) return false;
    const std::optional<std::vector<std::uint32_t>> indices = read_indices(shape->count);
    if (!indices) return false;
    const auto numbers = accessors_.numbers(*position, "VEC3");
    if (!numbers) return false;
    primitive_.position_accessor = position;
    primitive_.positions = as_points(*numbers);
    make_triangles(*indices, mode);
    return true;
  }

  [[nodiscard]] std::string texture_attribute() const {
    const std::uint64_t material = primitive_.material.value_or(texture_sets_.size());
    return "TEXCOORD_" + std::to_string(material < texture_sets_.size() ? texture_sets_[material] : 0);
  }

  void read_attributes() {
    const JsonView attributes = json_.object("attributes");
    if (const auto accessor = attributes.whole(texture_attribute())) {
      if (const auto numbers = numbers_of(*accessor, "VEC2")) primitive_.texture_coordinates = as_pairs(*numbers);
      primitive_.texture_accessor = accessor;
    }
    if (const auto accessor = attributes.whole("NORMAL")) {
      if (const auto numbers = numbers_of(*accessor, "VEC3")) primitive_.normals = as_points(*numbers);
      primitive_.normal_accessor = accessor;
    }
  }

  // Nothing where there are not as many as positions: what does not fit is not read at all.
  std::optional<std::vector<double>> numbers_of(std::uint64_t accessor, std::string_view type) const {
    const auto shape = accessors_.shape(accessor, type);
    if (!shape) return std::nullopt;
    if (shape->count == primitive_.positions.size()) return accessors_.numbers(accessor, type);
    add_unsupported("attributes with another number of values than positions");
    return std::nullopt;
  }

  void drop_misfits() {
    const std::size_t count = primitive_.positions.size();
    if (primitive_.texture_coordinates.size() != count) primitive_.texture_coordinates.clear();
    if (primitive_.normals.size() != count) primitive_.normals.clear();
  }

  // Without an accessor of indices, the vertices stand in the order of use.
  std::optional<std::vector<std::uint32_t>> read_indices(std::uint64_t vertex_count) const {
    if (!json_.has("indices")) {
      if (vertex_count > buffers_.backing_bytes()) {
        report("the primitive counts more vertices than the file has bytes");
        return std::nullopt;
      }
      std::vector<std::uint32_t> indices(vertex_count);
      for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::uint32_t>(i);
      return indices;
    }
    const auto accessor = json_.whole("indices");
    const auto shape = accessor ? accessors_.shape(*accessor, "SCALAR") : std::nullopt;
    if (!shape || !within_limit(shape->count, document_.input.limits.corners, "corners")) return std::nullopt;
    return accessors_.indices(*accessor);
  }

  void make_triangles(const std::vector<std::uint32_t>& indices, std::uint64_t mode) {
    const std::size_t size = indices.size();
    if (mode == kTriangles) {
      if (size % 3 != 0) report("the last " + std::to_string(size % 3) + " corners make no triangle");
      for (std::size_t i = 0; i + 3 <= size; i += 3) add({indices[i], indices[i + 1], indices[i + 2]}, i / 3);
      return;
    }
    if (size < 3) report("a strip or fan of " + std::to_string(size) + " corners makes no triangle");
    for (std::size_t i = 0; i + 3 <= size; ++i) {
      if (mode == kTriangleFan) {
        add({indices[i + 1], indices[i + 2], indices[0]}, i);
      } else {
        // Every other triangle of a strip runs backwards.
        add({indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]}, i);
      }
    }
  }

  void add(const std::array<std::uint32_t, 3>& corners, std::uint64_t record) {
    const std::uint32_t largest = *std::max_element(corners.begin(), corners.end());
    if (largest < primitive_.positions.size()) {
      primitive_.triangles.push_back({corners, static_cast<std::uint32_t>(record)});
      return;
    }
    scene::ReadIssue issue;
    issue.kind = scene::ReadIssueKind::IndexOutOfRange;
    issue.what = "vertex index " + std::to_string(largest) + " of triangle " + std::to_string(record) +
                 " exceeds the " + std::to_string(primitive_.positions.size()) + " vertices of the primitive";
    issue.place.pointer = json_.pointer();
    document_.issues.add(std::move(issue));
  }

  bool read_draco(const JsonView& draco) {
    const auto view = draco.whole("bufferView");
    const auto position = draco.object("attributes").whole("POSITION");
    if (!view || !position || *position > 0xffffffffu) {
      report("the Draco extension names no buffer view or no POSITION");
      return false;
    }
    const auto stream = buffers_.view(*view);
    if (!stream) return false;
    const auto& limits = document_.input.limits;
    DracoIds ids;
    ids.position = static_cast<std::uint32_t>(*position);
    ids.texture_coordinates = draco_id(draco, texture_attribute());
    ids.normals = draco_id(draco, "NORMAL");
    DracoMesh mesh = decode_draco(*stream, ids, std::min(limits.vertices, limits.faces));
    if (!mesh.fault.empty()) {
      report(mesh.fault);
      return false;
    }
    primitive_.positions = std::move(mesh.positions);
    primitive_.texture_coordinates = std::move(mesh.texture_coordinates);
    primitive_.normals = std::move(mesh.normals);
    if (mesh.stored_as_integers && !scale_as_accessor_says()) return false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) add(mesh.triangles[i], i);
    return true;
  }

  static std::optional<std::uint32_t> draco_id(const JsonView& draco, std::string_view attribute) {
    const auto id = draco.object("attributes").whole(attribute);
    return id && *id <= 0xffffffffu ? std::optional(static_cast<std::uint32_t>(*id)) : std::nullopt;
  }

  // The accessor of a compressed attribute has no bytes, but says what its integers stand for.
  bool scale_as_accessor_says() {
    const auto accessor = json_.object("attributes").whole("POSITION");
    const auto shape = accessor ? accessors_.shape(*accessor, "VEC3") : std::nullopt;
    if (!shape) {
      report("no accessor says what the integers of the Draco stream stand for");
      return false;
    }
    if (!shape->normalized) return true;
    for (geom::dvec3& point : primitive_.positions) {
      for (int axis = 0; axis < 3; ++axis) point[axis] = normalized_value(point[axis], shape->type);
    }
    return true;
  }

  const Document& document_;
  const Buffers& buffers_;
  const Accessors& accessors_;
  std::span<const std::uint64_t> texture_sets_;
  const JsonView& json_;
  Primitive primitive_;
};

}  // namespace

std::vector<Primitive> read_mesh(const Document& document, const Buffers& buffers, const Accessors& accessors,
                                 std::span<const std::uint64_t> texture_sets, std::uint64_t mesh) {
  std::vector<Primitive> primitives;
  const JsonView json = document.root().item("meshes", mesh);
  if (!json) return primitives;
  const std::size_t count = json.length("primitives");
  for (std::size_t i = 0; i < count; ++i) {
    const JsonView item = json.item("primitives", i);
    if (!item) continue;
    if (auto primitive = PrimitiveReader(document, buffers, accessors, texture_sets, item).read()) {
      primitives.push_back(std::move(*primitive));
    }
  }
  return primitives;
}

}  // namespace rad::readers::gltf
