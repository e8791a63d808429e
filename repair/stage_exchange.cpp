#include "repair/stage_exchange.h"

#include <algorithm>
#include <map>
#include <set>

#include "scene/repaired_scene.h"
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

// Each point of a chain mod 2 has an even number of edges, so that it falls apart into closed loops. They start at their
// least points and pass no point twice.
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

class ComplexScene {
 public:
  ComplexScene(const Complex& complex, const Scene& origin, const geom::Lattice& lattice, double tolerance)
      : complex_(complex),
        origin_(origin),
        lattice_(lattice),
        scene_(scene::without_geometry(origin)),
        record_(std::make_shared<StageRecord>()) {
    scene_.recorded = scene::RecordedLattice{lattice, tolerance};
    record_->work_tolerance = complex.tolerance();
  }

  Scene take() {
    gather_chains();
    number_points();
    add_planes();
    for (PieceId id = 0; id < chains_.size(); ++id) {
      if (!chains_[id].empty()) add_face(id);
    }
    scene_.stage = std::move(record_);
    return std::move(scene_);
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

  void number_points() {
    number_.assign(complex_.point_count(), scene::kNoPoint);
    for (PointId id = 0; id < complex_.point_count(); ++id) {
      if (!complex_.live(id)) continue;
      number_[id] = static_cast<PointId>(record_->points.size());
      record_->points.push_back(complex_.point(id));
      scene_.vertices.push_back(lattice_.position(complex_.point(id)));
    }
  }

  void add_planes() {
    for (ClusterId id = 0; id < complex_.clusters().size(); ++id) {
      const Cluster& cluster = complex_.clusters()[id];
      StagePlane plane{cluster.plane.normal, cluster.plane.offset, cluster.area, {}, {}};
      for (const auto& [a, b] : slits_[id]) plane.slits.push_back({number_[a], number_[b]});
      for (const PointId point : cluster.points) plane.points.push_back(number_[point]);
      record_->planes.push_back(std::move(plane));
    }
  }

  void add_face(PieceId id) {
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
    scene::Face face = origin_.faces[piece.source];
    face.first_loop = static_cast<std::uint32_t>(scene_.loops.size());
    face.loop_count = static_cast<std::uint32_t>(rings.size());
    for (const Ring& ring : rings) {
      scene_.loops.push_back(
          {static_cast<std::uint32_t>(scene_.corners.size()), static_cast<std::uint32_t>(ring.size())});
      for (const PointId point : ring) scene_.corners.push_back(number_[point]);
    }
    scene_.faces.push_back(face);
    record_->faces.push_back({piece.cluster, piece.along, piece.rank});
    record_->sources.push_back(scene::sources_of(origin_, piece.source));
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
  const Scene& origin_;
  const geom::Lattice& lattice_;
  Scene scene_;
  std::shared_ptr<StageRecord> record_;
  std::vector<Chain> chains_;               ///< per piece
  std::vector<Chain> slits_;                ///< per cluster
  std::vector<PointId> number_;             ///< per point of the complex: its number in the record
};

// Places of the vertices of a scene; those that are used are finite.
std::vector<LatticePoint> points_of(const Scene& scene, const geom::Lattice& lattice) {
  std::vector<LatticePoint> points;
  points.reserve(scene.vertices.size());
  for (const dvec3& vertex : scene.vertices) points.push_back(lattice.nearest(vertex));
  return points;
}

}  // namespace

Scene stage_scene(const Complex& complex, const Scene& origin, const geom::Lattice& lattice, double tolerance) {
  return ComplexScene(complex, origin, lattice, tolerance).take();
}

Scene stage_scene(const scene::ConformingModel& model, const PlanarTriangles& set, const Scene& origin) {
  Scene scene = scene::repaired_scene(model, origin, scene::Pieces::FacesAndAllPoints);
  auto record = std::make_shared<StageRecord>();
  record->points = model.points;
  record->work_tolerance = static_cast<double>(model.tolerance.pitches);
  for (const Plane& plane : set.planes) record->planes.push_back({plane.normal, plane.offset, 0, {}, {}});
  for (const scene::ConformingFace& face : model.faces) {
    record->faces.push_back({face.plane, face.along, 0});
    const auto triangles = model.triangles_of(face);
    record->triangles.emplace_back(triangles.begin(), triangles.end());
    auto& slits = record->planes[face.plane].slits;
    const auto inner = model.inner_edges_of(face);
    slits.insert(slits.end(), inner.begin(), inner.end());
    record->sources.push_back(scene::sources_of(model, face, origin));
  }
  for (StagePlane& plane : record->planes) {
    std::ranges::sort(plane.slits);
    const auto repeated = std::ranges::unique(plane.slits);
    plane.slits.erase(repeated.begin(), repeated.end());
  }
  scene.stage = std::move(record);
  return scene;
}

Scene stage_scene(const Scene& scene, const geom::Lattice& lattice, double tolerance) {
  Scene staged = scene;
  staged.recorded = scene::RecordedLattice{lattice, tolerance};
  auto record = std::make_shared<StageRecord>();
  record->work_tolerance = tolerance / lattice.pitch;
  record->points = points_of(scene, lattice);
  for (scene::FaceId face = 0; face < scene.faces.size(); ++face) {
    record->sources.push_back(scene::sources_of(scene, face));
  }
  staged.stage = std::move(record);
  return staged;
}

std::unique_ptr<Complex> complex_of(const Scene& scene) {
  const StageRecord& record = *scene.stage;
  auto complex = std::make_unique<Complex>(record.work_tolerance);
  for (const LatticePoint& point : record.points) complex->add_point(point);
  for (const StagePlane& plane : record.planes) complex->add_cluster(plane_of(plane), plane.area);
  for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
    const scene::StageFace& face = record.faces[id];
    const PieceId piece = complex->add_piece({face.plane, face.along, face.surface_rank, id});
    for (const scene::Loop& loop : scene.loops_of(scene.faces[id])) {
      const auto corners = scene.corners_of(loop);
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
  PlanarTriangles set;
  set.points = record.points;
  for (const StagePlane& plane : record.planes) set.planes.push_back(plane_of(plane));
  for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
    const scene::StageFace& face = record.faces[id];
    for (const auto& triangle : record.triangles[id]) {
      set.members.push_back({triangle, face.plane, face.along, id});
    }
  }
  return set;
}

}  // namespace rad::repair
