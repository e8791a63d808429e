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

template <typename Stored>
bool copy_positions(const draco::Mesh& source, const draco::PointAttribute& attribute, DracoMesh& mesh) {
  mesh.positions.reserve(source.num_points());
  for (draco::PointIndex point(0); point < source.num_points(); ++point) {
    const draco::AttributeValueIndex value = attribute.mapped_index(point);
    std::array<Stored, 3> stored{};
    if (value.value() >= attribute.size() || !attribute.ConvertValue<Stored, 3>(value, stored.data())) return false;
    mesh.positions.emplace_back(stored[0], stored[1], stored[2]);
  }
  return true;
}

void copy_triangles(const draco::Mesh& source, DracoMesh& mesh) {
  mesh.triangles.reserve(source.num_faces());
  for (draco::FaceIndex face(0); face < source.num_faces(); ++face) {
    const draco::Mesh::Face& corners = source.face(face);
    mesh.triangles.push_back({corners[0].value(), corners[1].value(), corners[2].value()});
  }
}

DracoMesh decode(std::string_view stream, std::uint32_t position_id, std::uint64_t largest_count) {
  draco::DecoderBuffer buffer;
  buffer.Init(stream.data(), stream.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return faulty("the Draco stream cannot be decoded");
  const std::unique_ptr<draco::Mesh> source = std::move(decoded).value();
  if (source->num_points() > largest_count || source->num_faces() > largest_count) {
    return faulty("the Draco mesh passes the limit of " + std::to_string(largest_count) + " vertices or triangles");
  }
  const draco::PointAttribute* attribute = source->GetAttributeByUniqueId(position_id);
  if (attribute == nullptr || attribute->num_components() != 3) {
    return faulty("the Draco stream has no attribute of three components with id " + std::to_string(position_id));
  }
  DracoMesh mesh;
  mesh.stored_as_integers = !is_float(attribute->data_type());
  const bool copied = mesh.stored_as_integers ? copy_positions<std::int32_t>(*source, *attribute, mesh)
                                              : copy_positions<float>(*source, *attribute, mesh);
  if (!copied) return faulty("the Draco stream lacks values of its positions");
  copy_triangles(*source, mesh);
  return mesh;
}

}  // namespace

DracoMesh decode_draco(std::string_view stream, std::uint32_t position_id, std::uint64_t largest_count) {
  try {
    return decode(stream, position_id, largest_count);
  } catch (const std::bad_alloc&) {
    return faulty("the Draco stream claims more than memory holds");
  } catch (const std::length_error&) {
    return faulty("the Draco stream claims more than memory holds");
  }
}

}  // namespace rad::readers::gltf
