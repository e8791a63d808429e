#include "writers/draco_stream.h"

#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>

namespace rad::writers {
namespace {

// Of Draco's 0 (shortest) to 10 (fastest): the middle is a tenth longer than 0 and several times as fast.
constexpr int kSpeed = 5;

draco::GeometryAttribute::Type draco_type(DracoUse use) {
  switch (use) {
    case DracoUse::Position:
      return draco::GeometryAttribute::POSITION;
    case DracoUse::Normal:
      return draco::GeometryAttribute::NORMAL;
    case DracoUse::Texture:
      return draco::GeometryAttribute::TEX_COORD;
    case DracoUse::Colour:
      return draco::GeometryAttribute::COLOR;
    case DracoUse::Other:
      break;
  }
  return draco::GeometryAttribute::GENERIC;
}

std::size_t bytes_of(const DracoAttribute& attribute) {
  return attribute.components * (attribute.number == DracoNumber::Float ? sizeof(float) : sizeof(std::uint16_t));
}

// Draco (1.5) hands an explicit origin and range of quantisation on as text with six decimals, and what is decoded is
// off the grid. Found from the values themselves they are exact: two values that no vertex has span the grid.
void add_span(draco::PointAttribute& position, std::uint32_t first, const DracoGrid& grid) {
  const float range = static_cast<float>(std::ldexp(1.0, grid.bits) - 1) * grid.step;
  for (const float share : {0.0F, range}) {
    const std::array<float, 3> place{grid.origin[0] + share, grid.origin[1] + share, grid.origin[2] + share};
    position.SetAttributeValue(draco::AttributeValueIndex(first++), place.data());
  }
}

/// Only the vertices that triangles use, in their order of first use.
std::unique_ptr<draco::Mesh> mesh_of(std::span<const DracoAttribute> attributes, std::span<const std::uint32_t> corners,
                                     const std::optional<DracoGrid>& grid) {
  constexpr std::uint32_t kUnseen = 0xffffffffU;
  std::vector<std::uint32_t> point_of(attributes.front().bytes.size() / bytes_of(attributes.front()), kUnseen), used;
  auto mesh = std::make_unique<draco::Mesh>();
  mesh->SetNumFaces(corners.size() / 3);
  for (std::size_t triangle = 0; triangle < corners.size() / 3; ++triangle) {
    draco::Mesh::Face face;
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& point = point_of[corners[3 * triangle + i]];
      if (point == kUnseen) {
        point = static_cast<std::uint32_t>(used.size());
        used.push_back(corners[3 * triangle + i]);
      }
      face[static_cast<int>(i)] = draco::PointIndex(point);
    }
    mesh->SetFace(draco::FaceIndex(static_cast<std::uint32_t>(triangle)), face);
  }
  mesh->set_num_points(static_cast<std::uint32_t>(used.size()));
  for (const DracoAttribute& attribute : attributes) {
    draco::GeometryAttribute description;
    const auto size = static_cast<std::int64_t>(bytes_of(attribute));
    description.Init(draco_type(attribute.use), nullptr, attribute.components,
                     attribute.number == DracoNumber::Float ? draco::DT_FLOAT32 : draco::DT_UINT16,
                     attribute.normalized, size, 0);
    const bool spans = grid && attribute.use == DracoUse::Position;
    const auto count = static_cast<std::uint32_t>(used.size());
    const int id = mesh->AddAttribute(description, false, count + (spans ? 2 : 0));
    draco::PointAttribute& values = *mesh->attribute(id);
    for (std::uint32_t i = 0; i < count; ++i) {
      values.SetAttributeValue(draco::AttributeValueIndex(i),
                               attribute.bytes.data() + std::size_t{used[i]} * bytes_of(attribute));
      values.SetPointMapEntry(draco::PointIndex(i), draco::AttributeValueIndex(i));
    }
    if (spans) add_span(values, count, *grid);
  }
  return mesh;
}

std::unique_ptr<draco::GeometryMetadata> metadata_of(std::span<const DracoEntry> entries) {
  auto metadata = std::make_unique<draco::GeometryMetadata>();
  for (const DracoEntry& entry : entries) metadata->AddEntryDouble(entry.name, entry.value);
  return metadata;
}

using TriangleHash = std::array<std::uint64_t, 3>;

// Which corner a triangle begins with means nothing.
TriangleHash from_least(TriangleHash triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

/// The triangles with all that their corners have, whatever their order. 64 bits of hash a corner: that two different
/// models agree is less likely than a fault of memory.
std::vector<TriangleHash> triangles_of(const draco::Mesh& mesh) {
  std::vector<std::uint64_t> hash(mesh.num_points(), 0);
  std::array<char, 64> chained{};
  for (int id = 0; id < mesh.num_attributes(); ++id) {
    const draco::PointAttribute& attribute = *mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
    const auto size = static_cast<std::size_t>(attribute.byte_stride());
    for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
      std::memcpy(chained.data(), &hash[point], sizeof hash[point]);
      attribute.GetMappedValue(draco::PointIndex(point), chained.data() + sizeof hash[point]);
      hash[point] = std::hash<std::string_view>()({chained.data(), sizeof hash[point] + size});
    }
  }
  std::vector<TriangleHash> triangles;
  triangles.reserve(mesh.num_faces());
  for (std::uint32_t face = 0; face < mesh.num_faces(); ++face) {
    const draco::Mesh::Face& corners = mesh.face(draco::FaceIndex(face));
    triangles.push_back(from_least({hash[corners[0].value()], hash[corners[1].value()], hash[corners[2].value()]}));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::string encoded(const draco::Mesh& mesh, int method, const std::optional<DracoGrid>& grid) {
  draco::ExpertEncoder encoder(mesh);
  encoder.SetSpeedOptions(kSpeed, kSpeed);
  encoder.SetEncodingMethod(method);
  const int position = mesh.GetNamedAttributeId(draco::GeometryAttribute::POSITION);
  if (grid) encoder.SetAttributeQuantization(position, grid->bits);
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeToBuffer(&buffer).ok()) return {};
  return {buffer.data(), buffer.size()};
}

std::unique_ptr<draco::Mesh> decoded(const std::string& bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  return mesh.ok() ? std::move(mesh).value() : nullptr;
}

}  // namespace

std::optional<DracoGrid> draco_grid(const geom::dvec3& low, const geom::dvec3& high, double step) {
  DracoGrid grid{{}, static_cast<float>(step), 1};
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    grid.origin[axis] = static_cast<float>(low[axis]);
    most = std::max(most, (high[axis] - low[axis]) / step);
  }
  while (std::ldexp(1.0, grid.bits) - 1 < most) ++grid.bits;
  return grid.bits <= kMostDracoBits ? std::optional(grid) : std::nullopt;
}

DracoStream draco_stream(std::span<const DracoAttribute> attributes, std::span<const std::uint32_t> corners,
                         const std::optional<DracoGrid>& grid, std::span<const DracoEntry> entries) {
  DracoStream stream;
  for (const std::optional<DracoGrid>& tried : {grid, std::optional<DracoGrid>()}) {
    const std::unique_ptr<draco::Mesh> mesh = mesh_of(attributes, corners, tried);
    if (!entries.empty()) mesh->AddMetadata(metadata_of(entries));
    const std::vector<TriangleHash> wanted = triangles_of(*mesh);
    for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
      std::string bytes = encoded(*mesh, method, tried);
      const std::unique_ptr<draco::Mesh> back = bytes.empty() ? nullptr : decoded(bytes);
      if (!back || triangles_of(*back) != wanted) continue;
      for (int id = 0; id < mesh->num_attributes(); ++id) stream.id.push_back(mesh->attribute(id)->unique_id());
      stream.bytes = std::move(bytes);
      stream.vertices = back->num_points();
      stream.triangles = back->num_faces();
      return stream;
    }
  }
  return stream;
}

}  // namespace rad::writers
