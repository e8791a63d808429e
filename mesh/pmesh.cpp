#include "mesh/pmesh.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "mesh/edge_division.h"
#include "mesh/edge_sizes.h"
#include "mesh/face_patches.h"
#include "mesh/flat_faces.h"
#include "mesh/lengths.h"
#include "mesh/patch_memory.h"
#include "mesh/patch_sectors.h"
#include "mesh/sharp_edges.h"
#include "mesh/thin_patches.h"

namespace rad::mesh {
namespace {

using geom::LatticePoint;

constexpr std::uint32_t kNoIndex = 0xffffffffU;

// A new division of edges can leave a side unparted only where its points had no room: a second round shows it.
constexpr int kPartingRounds = 3;

constexpr int kSizePasses = 2;

class PatchMesher {
 public:
  PatchMesher(const DividedModel& divided, const PatchOptions& options, std::span<const EdgeKey> whole,
              PatchMemory& memory)
      : model_(divided.model), options_(options), whole_(whole), memory_(memory) {
    const double least = kShortestPatchInTolerances * static_cast<double>(model_.tolerance.pitches);
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      frames_.emplace_back(model_, model_.faces[f]);
      longest_.push_back(std::max(asked_length(model_.faces[f], divided.origin[f]) / model_.lattice.pitch, least));
    }
    sharp_ = sharp_edges(model_, frames_, least_spacing(model_.tolerance));
  }

  /// After run().
  [[nodiscard]] std::vector<bool> thin_faces() const {
    return faces_with_thin_patches(soup_, mesh_.points, model_.faces.size(), model_.tolerance);
  }

  PatchOutcome run() {
    if (std::string problem = too_many(); !problem.empty()) return {std::nullopt, std::move(problem)};
    const EdgeSizes sizes = options_.method == PatchMethod::Graded ? graded_sizes() : EdgeSizes{};
    std::vector<EdgeKey> halved;
    for (int round = 0;; ++round) {
      const EdgeDivision division(model_, longest_, halved, whole_, sizes, sharp_);
      if (std::string problem = mesh_faces(division); !problem.empty()) return {std::nullopt, std::move(problem)};
      join(division.points());
      const Sectors sectors = find_sectors(soup_, mesh_.faces, contacts(division));
      const std::size_t known = halved.size();
      add_undivided(sectors.unparted, division, halved);
      if (halved.size() == known || round == kPartingRounds) {
        connect(sectors);
        return {mesh_, {}};
      }
    }
  }

 private:
  [[nodiscard]] double asked_length(const scene::ConformingFace& face, std::uint32_t origin) const {
    const bool own = origin < options_.longest_of_face.size() && options_.longest_of_face[origin] > 0;
    const double asked = own ? options_.longest_of_face[origin] : options_.longest_edge;
    const bool emits = face.material < options_.materials.size() && options_.materials[face.material].emits();
    return asked * (emits ? options_.emitter_share : 1);
  }

  // Narrow places are seen by the points that edges have there already: every pass sees narrower ones.
  [[nodiscard]] EdgeSizes graded_sizes() const {
    EdgeSizes sizes;
    for (int pass = 0; pass < kSizePasses; ++pass) {
      const EdgeDivision division(model_, longest_, {}, whole_, sizes, sharp_);
      sizes = edge_sizes(model_, division, outlines(division));
    }
    return sizes;
  }

  [[nodiscard]] std::vector<FaceOutline> outlines(const EdgeDivision& division) const {
    std::vector<FaceOutline> result(model_.faces.size());
    tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t f) {
      if (frames_[f].has_area()) result[f] = face_outline(model_, model_.faces[f], division);
    });
    return result;
  }

  // Patches have about half the area of a square of the longest edge; narrow faces get what their outline asks for.
  [[nodiscard]] std::string too_many() const {
    double count = 0;
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      count += 2 * frames_[f].area() / (longest_[f] * longest_[f]);
      for (const scene::Loop& loop : model_.loops_of(model_.faces[f])) {
        const auto ring = model_.corners_of(loop);
        for (std::size_t i = 0; i < ring.size(); ++i)
          count += 1 + length(ring[i], ring[(i + 1) % ring.size()]) / longest_[f];
      }
    }
    if (count <= static_cast<double>(options_.most_patches)) return {};
    return fmt::format("about {:.3g} patches would be needed, more than the limit of {}: ask for longer patches", count,
                       options_.most_patches);
  }

  [[nodiscard]] double length(PointId a, PointId b) const {
    return std::sqrt(static_cast<double>(geom::squared_distance(model_.points[a], model_.points[b])));
  }

  std::string mesh_faces(const EdgeDivision& division) {
    const std::size_t count = model_.faces.size();
    outlines_ = outlines(division);
    parts_.assign(count, {});
    std::vector<PatchMemory::Key> fresh(count);
    std::vector<char> too_wide(count, 0);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t f) {
      if (!frames_[f].has_area()) return;
      const FaceLengths lengths{longest_[f], least_spacing(model_.tolerance), model_.tolerance.pitches,
                                options_.method};
      PatchMemory::Key key =
          PatchMemory::key_of(frames_[f].normal(), outlines_[f], division.points(), lengths, sharp_[f]);
      if (const FacePatches* known = memory_.find(key)) {
        parts_[f] = *known;
        return;
      }
      too_wide[f] = grid_size(frames_[f], outlines_[f], division.points(), lengths) > kMostBoxes;
      if (too_wide[f] == 0) {
        const ClearZone zone(model_, sharp_[f]);
        parts_[f] = face_patches(frames_[f], outlines_[f], division.points(), lengths, zone);
      }
      fresh[f] = std::move(key);
    });
    for (std::size_t f = 0; f < count; ++f) {
      if (too_wide[f] != 0) return fmt::format("the grid over face {} is too fine: ask for longer patches", f);
      if (parts_[f].patches.empty() && frames_[f].has_area()) {
        return fmt::format("the outline of face {} crosses itself: the model is not conforming", f);
      }
      if (!fresh[f].empty()) memory_.keep(std::move(fresh[f]), parts_[f]);
    }
    return {};
  }

  // Patches of all faces with one numbering of points: the division's, then those added in faces that a patch uses.
  void join(const std::vector<LatticePoint>& division_points) {
    mesh_ = {model_.lattice, model_.tolerance, division_points, {}, {}};
    soup_ = {};
    for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
      const scene::ConformingFace& face = model_.faces[f];
      const double pitch = model_.lattice.pitch;
      mesh_.faces.push_back({frames_[f].normal(), frames_[f].area() * pitch * pitch, face.material, face.object,
                             face.group, f, false, least_corner_of(face, frames_[f].normal())});
      const auto own = static_cast<std::uint32_t>(outlines_[f].ids.size());
      std::vector<std::uint32_t> index = outlines_[f].ids;
      index.resize(own + parts_[f].added.size(), kNoIndex);
      for (PatchCorners patch : parts_[f].patches) {
        for (std::uint32_t slot = 0; slot < patch.count; ++slot) {
          std::uint32_t& known = index[patch.point[slot]];
          if (known == kNoIndex) {
            known = static_cast<std::uint32_t>(mesh_.points.size());
            mesh_.points.push_back(parts_[f].added[patch.point[slot] - own]);
          }
          patch.point[slot] = known;
        }
        soup_.corners.push_back(patch);
        soup_.face.push_back(f);
      }
    }
  }

  // Degrees, on the side of the face.
  [[nodiscard]] double least_corner_of(const scene::ConformingFace& face, const geom::dvec3& normal) const {
    double least = std::numbers::pi;
    for (const scene::Loop& loop : model_.loops_of(face)) {
      const auto ring = model_.corners_of(loop);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto at = [&](std::size_t k) { return geom::as_vector(model_.points[ring[k % ring.size()]]); };
        const geom::dvec3 to = at(i + 1) - at(i), back = at(i + ring.size() - 1) - at(i);
        const geom::dvec3 turn = glm::cross(to, back);
        if (glm::dot(turn, normal) > 0) least = std::min(least, std::atan2(glm::length(turn), glm::dot(to, back)));
      }
    }
    return least * 180 / std::numbers::pi;
  }

  [[nodiscard]] std::vector<PointPair> contacts(const EdgeDivision& division) const {
    std::vector<PointPair> pairs;
    std::vector<PointId> chain;
    for (const auto& edge : model_.inner_edges) {
      chain.clear();
      division.append_chain(edge[0], edge[1], chain);
      chain.push_back(edge[1]);
      for (std::size_t i = 1; i < chain.size(); ++i) {
        pairs.push_back({std::min(chain[i - 1], chain[i]), std::max(chain[i - 1], chain[i])});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  // Adds the edges of the model among `unparted` to `halved`.
  void add_undivided(std::span<const PointPair> unparted, const EdgeDivision& division,
                     std::vector<EdgeKey>& halved) const {
    for (const PointPair& pair : unparted) {
      if (pair[1] >= model_.points.size()) continue;
      halved.push_back(division.key(pair[0], pair[1]));
    }
    std::sort(halved.begin(), halved.end());
    halved.erase(std::unique(halved.begin(), halved.end()), halved.end());
  }

  void connect(const Sectors& sectors) {
    PatchConnectivity& patches = mesh_.patches;
    std::vector<std::uint32_t> point(sectors.node_count);
    for (std::size_t p = 0; p < soup_.corners.size(); ++p) {
      for (std::uint32_t slot = 0; slot < soup_.corners[p].count; ++slot) {
        point[sectors.node[p][slot]] = soup_.corners[p].point[slot];
      }
    }
    for (const std::uint32_t p : point) add_vertex(p);
    for (std::size_t p = 0; p < soup_.corners.size(); ++p) {
      const std::span<const std::uint32_t> nodes(sectors.node[p].data(), soup_.corners[p].count);
      std::vector<PatchConnectivity::VertexHandle> handles;
      for (const std::uint32_t node : nodes) handles.emplace_back(static_cast<int>(node));
      auto face = patches.add_face(handles);
      if (!face.is_valid()) face = add_apart(soup_.corners[p]);
      patches.data(face).face = soup_.face[p];
    }
  }

  // A patch at an edge too short to be divided, so that its sides could not be parted: it gets nodes of its own.
  OpenMesh::SmartFaceHandle add_apart(const PatchCorners& corners) {
    std::vector<PatchConnectivity::VertexHandle> handles;
    for (std::uint32_t slot = 0; slot < corners.count; ++slot) handles.push_back(add_vertex(corners.point[slot]));
    return mesh_.patches.add_face(handles);
  }

  PatchConnectivity::VertexHandle add_vertex(std::uint32_t point) {
    const LatticePoint& p = mesh_.points[point];
    const auto handle = mesh_.patches.add_vertex(OpenMesh::Vec3d(p.x, p.y, p.z));
    mesh_.patches.data(handle).lattice_point = point;
    return handle;
  }

  static constexpr double kMostBoxes = 1 << 26;  // of one face's grid, a byte or two each

  const scene::ConformingModel& model_;
  const PatchOptions& options_;
  std::span<const EdgeKey> whole_;
  PatchMemory& memory_;
  std::vector<FaceFrame> frames_;
  std::vector<double> longest_;  // pitches, of each face
  std::vector<std::vector<SharpEdge>> sharp_;
  std::vector<FaceOutline> outlines_;
  std::vector<FacePatches> parts_;
  PatchSoup soup_;
  PatchMesh mesh_;
};

// Faces with thin patches are first divided along the triangles that repair has proven; triangles that still get thin
// patches keep their edges whole, and with them their shape. Each round leaves fewer to divide.
constexpr int kThinRounds = 6;

EdgeKey edge_of(const scene::ConformingModel& model, PointId a, PointId b) {
  return model.points[a] < model.points[b] ? EdgeKey{a, b} : EdgeKey{b, a};
}

void keep_whole(const scene::ConformingModel& model, const std::vector<bool>& thin, std::vector<EdgeKey>& whole) {
  for (std::size_t f = 0; f < thin.size(); ++f) {
    if (!thin[f] || model.faces[f].triangle_count != 1) continue;
    const auto& corners = model.triangles_of(model.faces[f]).front();
    for (std::size_t i = 0; i < 3; ++i) whole.push_back(edge_of(model, corners[i], corners[(i + 1) % 3]));
  }
  std::sort(whole.begin(), whole.end());
  whole.erase(std::unique(whole.begin(), whole.end()), whole.end());
}

std::vector<bool> faces_from(const DividedModel& divided, const std::vector<std::uint32_t>& origins) {
  std::vector<bool> chosen;
  chosen.reserve(divided.origin.size());
  for (const std::uint32_t origin : divided.origin) {
    chosen.push_back(std::binary_search(origins.begin(), origins.end(), origin));
  }
  return chosen;
}

DividedModel whole_and_flat(const scene::ConformingModel& given, const PatchOptions& options) {
  DividedModel divided{given, {}};
  for (std::uint32_t face = 0; face < given.faces.size(); ++face) divided.origin.push_back(face);
  std::vector<bool> kept = flat_faces(given);
  for (const std::uint32_t face : options.whole_faces) kept[face] = false;
  return with_triangles(divided, kept);
}

void note_origins(const DividedModel& divided, const std::vector<std::uint32_t>& whole_faces, PatchMesh& mesh) {
  const std::vector<bool> whole = faces_from(divided, whole_faces);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    mesh.faces[f].origin = divided.origin[f];
    mesh.faces[f].whole = whole[f];
  }
}

}  // namespace

PatchOutcome pmesh(const scene::ConformingModel& given, const PatchOptions& asked, PatchMemory& memory) {
  PatchOptions options = asked;
  if (!(options.longest_edge > 0)) options.longest_edge = default_patch_length(given);
  DividedModel divided = whole_and_flat(given, options);
  std::vector<EdgeKey> whole;
  keep_whole(divided.model, faces_from(divided, options.whole_faces), whole);
  for (int round = 0;; ++round) {
    PatchMesher mesher(divided, options, whole, memory);
    PatchOutcome outcome = mesher.run();
    if (!outcome.mesh) return outcome;
    std::vector<bool> thin = mesher.thin_faces();
    if (round == kThinRounds || std::find(thin.begin(), thin.end(), true) == thin.end()) {
      note_origins(divided, options.whole_faces, *outcome.mesh);
      return outcome;
    }
    keep_whole(divided.model, thin, whole);
    thin.flip();
    divided = with_triangles(divided, thin);
  }
}

PatchOutcome pmesh(const scene::ConformingModel& model, const PatchOptions& options) {
  PatchMemory memory;
  return pmesh(model, options, memory);
}

double default_patch_length(const scene::ConformingModel& model) {
  constexpr double kWantedPatches = 600;  // of that many squares; rounding up the division of edges makes it more
  double area = 0;
  for (const scene::ConformingFace& face : model.faces) area += FaceFrame(model, face).area();
  const double least = kShortestPatchInTolerances * static_cast<double>(model.tolerance.pitches);
  return std::max(std::sqrt(area / kWantedPatches), least) * model.lattice.pitch;
}

}  // namespace rad::mesh
