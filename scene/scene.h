// The raw model: an indexed polygon soup exactly as it was read. It can hold a bad model; nothing here is merged,
// rounded or repaired.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/lattice.h"
#include "geom/vec.h"
#include "scene/corner_values.h"
#include "scene/texture.h"

namespace rad::scene {

using geom::dvec3;

using VertexId = std::uint32_t;
using FaceId = std::uint32_t;
using MaterialId = std::uint32_t;
using ObjectId = std::uint32_t;
using GroupId = std::uint32_t;
using EntityId = std::uint32_t;

/// A diffuse, possibly emitting material. Colours are linear RGB.
struct Material {
  std::string name;
  dvec3 reflectance{0.5, 0.5, 0.5};  ///< diffuse, 0..1 in a sound model; 0.5 where the file states none
  dvec3 emission{0, 0, 0};           ///< as the file states it; `emission_unit` says what it is
  enum class EmissionUnit { Exitance, Luminance } emission_unit = EmissionUnit::Exitance;  ///< W/m² | cd/m²
  bool reflectance_stated = false;
  dvec3 specular{0, 0, 0};          ///< reflectance in the direction of a mirror; a diffuse solution leaves it out
  double opacity = 1;               ///< 0 clear glass, 1 lets no light through; faces are solved as opaque
  bool cut_out = false;             ///< a picture says where the surface has holes
  bool emission_cancelled = false;  ///< a light is stated by a picture or a strength, and a factor of 0 puts it out
  bool double_sided = false;
  std::optional<Texture> texture;  ///< over the diffuse colour; reflectance does not hang on it

  [[nodiscard]] bool emits() const { return emission.x > 0 || emission.y > 0 || emission.z > 0; }
};

/// How the record number of a SourceRef is to be read; an item is one of the array that a JSON pointer names.
enum class RecordKind : std::uint8_t { Line, Element, ByteOffset, Item };

/// One stretch of the source in which records are counted alike: a text file, a glTF primitive, a binary section.
struct SourceSection {
  std::string file;     ///< path as the user gave it, or of the companion file
  std::string pointer;  ///< JSON pointer for formats in JSON, empty elsewhere
  RecordKind kind = RecordKind::Line;
};

/// Where a face or vertex came from: record (1-based line, 0-based element, or byte offset) of a section.
struct SourceRef {
  std::uint32_t section = 0;
  std::uint64_t record = 0;
  friend constexpr auto operator<=>(const SourceRef&, const SourceRef&) = default;
};

/// A closed chain of `count` corners starting at `first` in Scene::corners.
struct Loop {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// A face: loops[first_loop] is the outer loop, counter-clockwise seen from the front; the others are holes.
struct Face {
  std::uint32_t first_loop = 0;
  std::uint32_t loop_count = 1;
  MaterialId material = 0;
  ObjectId object = 0;
  GroupId group = 0;
  EntityId entity = 0;
  SourceRef source;
};

enum class UpAxis { Unknown, Y, Z };

/// The lattice and tolerance of the run of radfix that wrote a file, as the file records them.
struct RecordedLattice {
  geom::Lattice lattice;
  double tolerance = 0;  ///< file units
};

struct StageRecord;

struct Scene {
  std::string path;    ///< as the user gave it
  std::string format;  ///< "obj", "stl", "gltf", "dxf"…

  std::vector<dvec3> vertices;                ///< file units; components may be non-finite
  std::vector<std::uint64_t> vertex_records;  ///< per vertex, record in `vertex_section`; empty where unknown
  std::uint32_t vertex_section = 0;

  std::vector<VertexId> corners;  ///< every id is below vertices.size()
  std::vector<Loop> loops;
  std::vector<Face> faces;

  CornerAttributes attributes;                  ///< of corners: texture coordinates and normals
  std::vector<std::uint32_t> smoothing_groups;  ///< per face, 0 for none (OBJ: s off); empty where no face has one

  std::vector<Material> materials;    ///< at least one; 0 is the material of faces that name none
  std::vector<std::string> objects;   ///< at least one; 0 is the unnamed object
  std::vector<std::string> groups;    ///< at least one; 0 is the unnamed group
  std::vector<std::string> entities;  ///< at least one;  names that records have in their file ("handle 2F"); 0 is none
  std::vector<SourceSection> sections;

  std::optional<double> metres_per_unit;  ///< declared by the format or given by the user
  UpAxis up = UpAxis::Unknown;
  std::optional<double> declared_tolerance;  ///< file units; lengths below it say nothing to what wrote the file
  std::optional<RecordedLattice> recorded;   ///< so that a second run works on the same lattice
  std::shared_ptr<const StageRecord> stage;  ///< of a model between two filters (stage_record.h); null elsewhere
  bool single_precision = false;             ///< the file stores coordinates as 32-bit floats
  bool triangles_only = false;               ///< the format cannot hold larger faces
  bool splits_vertices = false;              ///< the format repeats a vertex per face or per attribute seam

  [[nodiscard]] std::span<const VertexId> corners_of(const Loop& loop) const {
    return std::span(corners).subspan(loop.first, loop.count);
  }
  [[nodiscard]] std::span<const Loop> loops_of(const Face& face) const {
    return std::span(loops).subspan(face.first_loop, face.loop_count);
  }
};

/// A scene with the unnamed material, object and group in place.
Scene empty_scene(std::string path, std::string format);

/// Materials, names, sections, unit and axis of a scene, without vertices and faces.
Scene without_geometry(const Scene& scene);

/// Whether the face has texture coordinates at its corners.
bool has_texture_coordinates(const Scene& scene, const Face& face);

}  // namespace rad::scene
