#include "repair/stage_exchange.h"

#include <algorithm>
#include <map>
#include <set>

#include "scene/scene_sources.h"
#include "scene/stage_record.h"

namespace rad::repair {
namespace {

using scene::Scene;
using scene::StagePlane;
using scene::StageRecord;

using Chain = std::vector<std::array<PointId, 2>>;
using Ring = std::vector<PointId>;

Plane plane_of(const StagePlane& stored) {
  // The constructor rounds; what is stored has been through it.
  Plane plane(stored.normal, LatticePoint{0, 0, 0});
  plane.normal = stored.normal;
  plane.offset = stored.offset;
  return plane;
}

// Each point of a chain mod 2 has an even number of edges, so that it falls apart into closed loops. They start at
// their least points and pass no point twice.
std::vector<Ring> rings_of(const Chain& chain) {
  std::map<PointId, std::set<PointId>> next;
  for (const auto& [a, b] : chain) {
    next[a].insert(b);
    next[b].insert(a);
  }
  std::vector<Ring> rings;
  while (!next.empty()) {
    Ring path{next.begin()->first};
    while (true) {
      const auto here = next.find(path.back());
      if (here == next.end()) break;
      const PointId to = *here->second.begin();
      for (const auto& [from, other] : {std::pair(path.back(), to), std::pair(to, path.back())}) {
        next[from].erase(other);
        if (next[from].empty()) next.erase(from);
      }
      const auto seen = std::ranges::find(path, to);
      if (seen == path.end()) {
        path.push_back(to);
        continue;
      }
      Ring ring(seen, path.end());
      std::ranges::rotate(ring, std::ranges::min_element(ring));
      rings.push_back(std::move(ring));
      path.erase(seen + 1, path.end());
    }
  }
  return rings;
}

class ComplexRecord {
 public:
  ComplexRecord(const Conformed& conformed, const Scene& origin)
      : complex_(*conformed.complex), triangulation_(conformed.triangulation), origin_(origin) {
    record_.work_tolerance = complex_.tolerance();
  }

  StageRecord take() {
    gather_chains();
    gather_triangles();
    number_points();
    add_planes();
    for (PieceId id = 0; id < chains_.size(); ++id) {
      if (!chains_[id].empty()) add_face(id);
    }
    return std::move(record_);
  }

 private:
  void gather_chains() {
    chains_.resize(complex_.pieces().size());
    slits_.resize(complex_.clusters().size());
    for (const EdgeKey edge : complex_.edges()) {
      for (const Item item : complex_.items(edge)) {
        if (item.is_piece()) {
          chains_[item.piece_id()].push_back(ends_of(edge));
        } else {
          slits_[item.imprinted_cluster()].push_back(ends_of(edge));
        }
      }
    }
  }

  void gather_triangles() {
    triangles_.resize(complex_.pieces().size());
    for (const std::uint32_t i : triangulation_.living()) {
      const Triangle& triangle = triangulation_.triangles()[i];
      for (const PieceId id : triangulation_.cover_of(triangle)) {
        if (complex_.pieces()[id].along == triangle.along) triangles_[id].push_back(triangle.points);
      }
    }
  }

  void number_points() {
    number_.assign(complex_.point_count(), scene::kNoPoint);
    for (PointId id = 0; id < complex_.point_count(); ++id) {
      if (!complex_.live(id)) continue;
      number_[id] = static_cast<PointId>(record_.points.size());
      record_.points.push_back(complex_.point(id));
    }
  }

  void add_planes() {
    for (ClusterId id = 0; id < complex_.clusters().size(); ++id) {
      const Cluster& cluster = complex_.clusters()[id];
      StagePlane plane{cluster.plane.normal, cluster.plane.offset, cluster.area, {}, {}};
      for (const auto& [a, b] : slits_[id]) plane.slits.push_back({number_[a], number_[b]});
      for (const PointId point : cluster.points) plane.points.push_back(number_[point]);
      std::ranges::sort(plane.points);
      record_.planes.push_back(std::move(plane));
    }
  }

  void add_face(PieceId id) {
    const Piece& piece = complex_.pieces()[id];
    const scene::Face& from = origin_.faces[piece.source];
    record_.faces.push_back({.first_loop = static_cast<std::uint32_t>(record_.loops.size()),
                             .material = from.material,
                             .object = from.object,
                             .group = from.group,
                             .plane = piece.cluster,
                             .along = piece.along,
                             .surface_rank = piece.rank,
                             .sources = scene::sources_of(origin_, piece.source)});
    for (Ring& ring : rings_of_piece(id)) {
      for (PointId& point : ring) point = number_[point];
      record_.add_loop(ring);
    }
    for (const auto& points : triangles_[id]) {
      record_.faces.back().triangles.push_back({number_[points[0]], number_[points[1]], number_[points[2]]});
    }
  }

  // The largest first and counter-clockwise seen from the front, the others clockwise.
  [[nodiscard]] std::vector<Ring> rings_of_piece(PieceId id) const {
    const Piece& piece = complex_.pieces()[id];
    std::vector<Ring> rings = rings_of(chains_[id]);
    const Plane& plane = complex_.clusters()[piece.cluster].plane;
    std::vector<double> areas;
    for (const Ring& ring : rings) areas.push_back((piece.along ? 1 : -1) * twice_area(ring, plane));
    const auto largest = std::ranges::max_element(areas, {}, [](double area) { return std::abs(area); });
    const auto outer = static_cast<std::size_t>(largest - areas.begin());
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if ((areas[i] > 0) != (i == outer)) std::reverse(rings[i].begin() + 1, rings[i].end());
    }
    std::swap(rings[0], rings[outer]);
    return rings;
  }

  [[nodiscard]] double twice_area(const Ring& ring, const Plane& plane) const {
    geom::Int128 twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto a = plane.project(complex_.point(ring[i]));
      const auto b = plane.project(complex_.point(ring[(i + 1) % ring.size()]));
      twice += geom::Int128{a.u} * b.v - geom::Int128{b.u} * a.v;
    }
    return static_cast<double>(twice);
  }

  const Complex& complex_;
  const Triangulation& triangulation_;
  const Scene& origin_;
  StageRecord record_;
  std::vector<Chain> chains_;                                   ///< per piece
  std::vector<Chain> slits_;                                    ///< per cluster
  std::vector<std::vector<std::array<PointId, 3>>> triangles_;  ///< per piece
  std::vector<PointId> number_;                                 ///< per point of the complex: its number in the record
};

void sort_slits(StageRecord& record) {
  for (StagePlane& plane : record.planes) {
    std::ranges::sort(plane.slits);
    const auto repeated = std::ranges::unique(plane.slits);
    plane.slits.erase(repeated.begin(), repeated.end());
  }
}

// The first face of the scene that stands for each face of the record.
std::vector<scene::FaceId> first_faces(const StageRecord& record) {
  std::vector<scene::FaceId> first(record.faces.size(), 0);
  for (std::size_t face = record.face_of.size(); face-- > 0;) {
    first[record.face_of[face]] = static_cast<scene::FaceId>(face);
  }
  return first;
}

}  // namespace

Scene stage_scene(const Conformed& conformed, const Scene& origin, const scene::RecordedLattice& lattice) {
  return scene::scene_of_stage(origin, ComplexRecord(conformed, origin).take(), lattice);
}

Scene stage_scene(const scene::ConformingModel& model, const PlanarTriangles& set, const Scene& origin) {
  StageRecord record;
  record.points = model.points;
  record.work_tolerance = static_cast<double>(model.tolerance.pitches);
  record.overlaps_resolved = true;
  for (const Plane& plane : set.planes) record.planes.push_back({plane.normal, plane.offset, 0, {}, {}});
  for (const scene::ConformingFace& face : model.faces) {
    const auto triangles = model.triangles_of(face);
    record.faces.push_back({.first_loop = static_cast<std::uint32_t>(record.loops.size()),
                            .material = face.material,
                            .object = face.object,
                            .group = face.group,
                            .plane = face.plane,
                            .along = face.along,
                            .sources = scene::sources_of(model, face, origin),
                            .triangles = {triangles.begin(), triangles.end()}});
    for (const scene::Loop& loop : model.loops_of(face)) record.add_loop(model.corners_of(loop));
    const auto inner = model.inner_edges_of(face);
    auto& slits = record.planes[face.plane].slits;
    slits.insert(slits.end(), inner.begin(), inner.end());
  }
  sort_slits(record);
  return scene::scene_of_stage(origin, std::move(record), {model.lattice, model.tolerance.length});
}

Scene stage_scene(const Scene& scene, const scene::RecordedLattice& lattice) {
  StageRecord record;
  record.work_tolerance = lattice.tolerance / lattice.lattice.pitch;
  record.vertices = scene.vertices;
  for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
    const scene::Face& face = scene.faces[id];
    record.faces.push_back({.first_loop = static_cast<std::uint32_t>(record.loops.size()),
                            .material = face.material,
                            .object = face.object,
                            .group = face.group,
                            .sources = scene::sources_of(scene, id)});
    for (const scene::Loop& loop : scene.loops_of(face)) record.add_loop(scene.corners_of(loop));
  }
  return scene::scene_of_stage(scene, std::move(record), lattice);
}

std::unique_ptr<Complex> complex_of(const Scene& scene) {
  const StageRecord& record = *scene.stage;
  const std::vector<scene::FaceId> first = first_faces(record);
  auto complex = std::make_unique<Complex>(record.work_tolerance);
  for (const LatticePoint& point : record.points) complex->add_point(point);
  for (const StagePlane& plane : record.planes) complex->add_cluster(plane_of(plane), plane.area);
  for (std::size_t id = 0; id < record.faces.size(); ++id) {
    const scene::StageFace& face = record.faces[id];
    const PieceId piece = complex->add_piece({face.plane, face.along, face.surface_rank, first[id]});
    for (const scene::Loop& loop : record.loops_of(face)) {
      const auto corners = record.corners_of(loop);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const PointId next = corners[(i + 1) % corners.size()];
        if (corners[i] != next) complex->toggle(edge_key(corners[i], next), Item::piece(piece));
      }
    }
  }
  for (ClusterId id = 0; id < record.planes.size(); ++id) {
    for (const auto& [a, b] : record.planes[id].slits) complex->toggle(edge_key(a, b), Item::imprint(id));
    for (const PointId point : record.planes[id].points) complex->imprint_point(id, point);
  }
  return complex;
}

PlanarTriangles triangles_of(const Scene& scene) {
  const StageRecord& record = *scene.stage;
  const std::vector<scene::FaceId> first = first_faces(record);
  PlanarTriangles set;
  set.points = record.points;
  for (const StagePlane& plane : record.planes) set.planes.push_back(plane_of(plane));
  for (std::size_t id = 0; id < record.faces.size(); ++id) {
    const scene::StageFace& face = record.faces[id];
    for (const auto& triangle : face.triangles) {
      set.members.push_back({triangle, face.plane, face.along, first[id]});
    }
  }
  return set;
}

}  // namespace rad::repair
