#include "readers/gltf_draco.h"

#include <draco/compression/decode.h>
#include <draco/core/decoder_buffer.h>
#include <draco/mesh/mesh.h>

#include <memory>
#include <new>
#include <stdexcept>

namespace rad::readers::gltf {

namespace {

DracoMesh faulty(std::string fault) {
  DracoMesh mesh;
  mesh.fault = std::move(fault);
  return mesh;
}

bool is_float(draco::DataType type) { return type == draco::DT_FLOAT32 || type == draco::DT_FLOAT64; }

/// One value for each point: Value is a vector of glm.
template <typename Stored, typename Value>
bool copy_values(const draco::Mesh& source, const draco::PointAttribute& attribute, std::vector<Value>& values) {
  constexpr auto kComponents = static_cast<int>(Value::length());
  values.reserve(source.num_points());
  for (draco::PointIndex point(0); point < source.num_points(); ++point) {
    const draco::AttributeValueIndex index = attribute.mapped_index(point);
    std::array<Stored, static_cast<std::size_t>(kComponents)> stored{};
    if (index.value() >= attribute.size()) return false;
    if (!attribute.ConvertValue<Stored, kComponents>(index, stored.data())) return false;
    Value& value = values.emplace_back();
    for (int i = 0; i < kComponents; ++i) value[i] = static_cast<double>(stored[static_cast<std::size_t>(i)]);
  }
  return true;
}

// What is no float, or is not there for every point, is left out.
template <typename Value>
void copy_floats(const draco::Mesh& source, std::optional<std::uint32_t> id, std::vector<Value>& values) {
  const draco::PointAttribute* attribute = id ? source.GetAttributeByUniqueId(*id) : nullptr;
  if (attribute == nullptr || attribute->num_components() != Value::length() || !is_float(attribute->data_type())) {
    return;
  }
  if (!copy_values<float>(source, *attribute, values)) values.clear();
}

void copy_triangles(const draco::Mesh& source, DracoMesh& mesh) {
  mesh.triangles.reserve(source.num_faces());
  for (draco::FaceIndex face(0); face < source.num_faces(); ++face) {
    const draco::Mesh::Face& corners = source.face(face);
    mesh.triangles.push_back({corners[0].value(), corners[1].value(), corners[2].value()});
  }
}

void copy_numbers(const draco::Mesh& source, DracoMesh& mesh) {
  if (source.GetMetadata() == nullptr) return;
  for (const auto& [name, entry] : source.GetMetadata()->entries()) {
    double value = 0;
    if (source.GetMetadata()->GetEntryDouble(name, &value)) mesh.numbers.emplace(name, value);
  }
}

DracoMesh decode(std::string_view stream, const DracoIds& ids, std::uint64_t largest_count) {
  draco::DecoderBuffer buffer;
  buffer.Init(stream.data(), stream.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return faulty("the Draco stream cannot be decoded");
  const std::unique_ptr<draco::Mesh> source = std::move(decoded).value();
  if (source->num_points() > largest_count || source->num_faces() > largest_count) {
    return faulty("the Draco mesh passes the limit of " + std::to_string(largest_count) + " vertices or triangles");
  }
  const draco::PointAttribute* attribute = ids.position ? source->GetAttributeByUniqueId(*ids.position)
                                                        : source->GetNamedAttribute(draco::GeometryAttribute::POSITION);
  if (attribute == nullptr || attribute->num_components() != 3) {
    return faulty(ids.position
                      ? "the Draco stream has no attribute of three components with id " + std::to_string(*ids.position)
                      : "the Draco stream has no positions");
  }
  DracoMesh mesh;
  mesh.stored_as_integers = !is_float(attribute->data_type());
  const bool copied = mesh.stored_as_integers ? copy_values<std::int32_t>(*source, *attribute, mesh.positions)
                                              : copy_values<float>(*source, *attribute, mesh.positions);
  if (!copied) return faulty("the Draco stream lacks values of its positions");
  copy_floats(*source, ids.texture_coordinates, mesh.texture_coordinates);
  copy_floats(*source, ids.normals, mesh.normals);
  copy_triangles(*source, mesh);
  copy_numbers(*source, mesh);
  return mesh;
}

}  // namespace

DracoMesh decode_draco(std::string_view stream, const DracoIds& ids, std::uint64_t largest_count) {
  try {
    return decode(stream, ids, largest_count);
  } catch (const std::bad_alloc&) {
    return faulty("the Draco stream claims more than memory holds");
  } catch (const std::length_error&) {
    return faulty("the Draco stream claims more than memory holds");
  }
}

}  // namespace rad::readers::gltf
