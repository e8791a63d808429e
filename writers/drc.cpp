#include "writers/drc.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "writers/draco_stream.h"
#include "writers/face_triangles.h"
#include "writers/gltf_frame.h"
#include "writers/little_endian.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

class DrcWriter {
 public:
  explicit DrcWriter(const Output& output) : output_(output), frame_(gltf::frame_of(output)) {}

  WriteResult write(const std::filesystem::path& path) {
    if (std::string problem = pack(); !problem.empty()) return {std::move(problem)};
    std::vector<DracoAttribute> attributes{{.use = DracoUse::Position, .bytes = positions_}};
    if (output_.light != nullptr) {
      attributes.push_back({DracoUse::Colour, DracoNumber::UnsignedShort, 3, true, colours_});
      attributes.push_back({.use = DracoUse::Other, .bytes = radiosity_});
    }
    const DracoStream stream = draco_stream(attributes, corners_, grid(), entries());
    if (stream.bytes.empty()) return {"Draco does not keep the triangles"};
    return {write_whole_file(path, stream.bytes)};
  }

 private:
  std::string pack() {
    const scene::Scene& scene = output_.scene;
    if (std::string problem = problem_of(output_); !problem.empty()) return problem;
    for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
      const auto triangles = triangles_of(scene, scene.faces[id]);
      if (!triangles) return unsplit_face(id);
      for (const Triangle& triangle : *triangles) {
        for (const std::uint32_t corner : triangle) corners_.push_back(scene.corners[corner]);
      }
    }
    for (scene::VertexId id = 0; id < scene.vertices.size(); ++id) {
      if (!append(id)) return "vertex " + std::to_string(id) + " is beyond single precision";
    }
    return {};
  }

  bool append(scene::VertexId id) {
    constexpr double kWhole = std::numeric_limits<std::uint16_t>::max();
    bool finite = true;
    for (int axis = 0; axis < 3; ++axis) {
      const float offset = frame_.offset(output_.scene.vertices[id][axis], axis);
      append_bytes(positions_, offset);
      low_[axis] = std::min(low_[axis], static_cast<double>(offset));
      high_[axis] = std::max(high_[axis], static_cast<double>(offset));
      finite = finite && std::isfinite(offset);
      if (output_.light == nullptr) continue;
      const double shown = std::clamp(output_.light->colour[id][axis], 0.0, 1.0);
      append_bytes(colours_, static_cast<std::uint16_t>(std::lround(shown * kWhole)));
      const auto radiosity = static_cast<float>(output_.light->radiosity[id][axis]);
      append_bytes(radiosity_, radiosity);
      finite = finite && std::isfinite(radiosity);
    }
    return finite;
  }

  [[nodiscard]] std::optional<DracoGrid> grid() const {
    if (frame_.pitch == 0) return std::nullopt;
    return draco_grid(low_, high_, frame_.pitch);
  }

  [[nodiscard]] std::vector<DracoEntry> entries() const {
    std::vector<DracoEntry> entries{{"radfix.origin.x", frame_.origin.x},
                                    {"radfix.origin.y", frame_.origin.y},
                                    {"radfix.origin.z", frame_.origin.z}};
    if (!output_.lattice) return entries;
    entries.push_back({"radfix.pitch", output_.lattice->lattice.pitch});
    entries.push_back({"radfix.tolerance", output_.lattice->tolerance});
    return entries;
  }

  const Output& output_;
  gltf::Frame frame_;
  std::vector<std::uint32_t> corners_;
  std::string positions_, colours_, radiosity_;
  geom::dvec3 low_{std::numeric_limits<double>::infinity()};
  geom::dvec3 high_{-std::numeric_limits<double>::infinity()};
};

}  // namespace

WriteResult write_drc(const Output& output, const std::filesystem::path& path) { return DrcWriter(output).write(path); }

}  // namespace rad::writers
