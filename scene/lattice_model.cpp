#include "scene/lattice_model.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/disjoint_sets.h"

namespace rad::scene {
namespace {

bool finite(const dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::vector<bool> used_vertices(const Scene& scene) {
  std::vector<bool> used(scene.vertices.size(), false);
  for (const VertexId id : scene.corners) used[id] = true;
  return used;
}

// Equal positions become one point; ids follow the order of positions.
void number_points(const Scene& scene, const std::vector<bool>& wanted, LatticeModel& model) {
  std::vector<std::pair<LatticePoint, VertexId>> placed;
  placed.reserve(scene.vertices.size());
  for (VertexId id = 0; id < scene.vertices.size(); ++id) {
    if (wanted[id]) placed.emplace_back(model.lattice.nearest(scene.vertices[id]), id);
  }
  tbb::parallel_sort(placed.begin(), placed.end());
  for (const auto& [point, id] : placed) {
    if (model.points.empty() || model.points.back() != point) model.points.push_back(point);
    model.point_of_vertex[id] = static_cast<PointId>(model.points.size() - 1);
  }
}

bool has_lost_corner(const Scene& scene, const LatticeModel& model, const Face& face) {
  for (const Loop& loop : scene.loops_of(face)) {
    for (const PointId id : model.corners_of(loop)) {
      if (id == kNoPoint) return true;
    }
  }
  return false;
}

// A file that was changed since may no longer fit its record; then all of it is passed over, for T is in its pitches.
const RecordedLattice* usable_record(const Scene& scene, const geom::Box& box) {
  if (!scene.recorded || !geom::holds(scene.recorded->lattice, box)) return nullptr;
  const RecordedLattice& record = *scene.recorded;
  return geom::is_usable_record(record.tolerance, record.lattice.pitch, box.diagonal()) ? &record : nullptr;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

LatticeModel build_lattice_model(const Scene& scene) {
  LatticeModel model;
  std::vector<bool> wanted = used_vertices(scene);
  for (VertexId id = 0; id < scene.vertices.size(); ++id) {
    if (!wanted[id]) continue;
    wanted[id] = finite(scene.vertices[id]);
    if (wanted[id]) model.box.add(scene.vertices[id]);
  }
  const RecordedLattice* record = usable_record(scene, model.box);
  model.lattice = record != nullptr ? record->lattice : geom::lattice_for(model.box);
  model.point_of_vertex.assign(scene.vertices.size(), kNoPoint);
  number_points(scene, wanted, model);
  model.corners.reserve(scene.corners.size());
  for (const VertexId id : scene.corners) model.corners.push_back(model.point_of_vertex[id]);
  model.left_out.resize(scene.faces.size());
  for (FaceId id = 0; id < scene.faces.size(); ++id) {
    model.left_out[id] = has_lost_corner(scene, model, scene.faces[id]);
  }
  return model;
}

geom::ToleranceBasis tolerance_basis(const Scene& scene, const LatticeModel& model) {
  geom::ToleranceBasis basis;
  basis.pitch = model.lattice.pitch;
  basis.diagonal = model.box.diagonal();
  basis.largest_magnitude = model.box.largest_magnitude();
  basis.single_precision = scene.single_precision;
  if (const RecordedLattice* record = usable_record(scene, model.box)) basis.recorded = record->tolerance;
  basis.declared = scene.declared_tolerance.value_or(0);

  DisjointSets components(model.points.size());
  for (FaceId id = 0; id < scene.faces.size(); ++id) {
    if (model.left_out[id]) continue;
    const auto loops = scene.loops_of(scene.faces[id]);
    if (loops[0].count == 0) continue;
    const PointId first = model.corners_of(loops[0])[0];
    for (const Loop& loop : loops) {
      for (const PointId corner : model.corners_of(loop)) components.unite(first, corner);
    }
  }
  std::vector<geom::Box> boxes(model.points.size());
  for (PointId id = 0; id < model.points.size(); ++id) boxes[components.find(id)].add(model.position(id));
  std::vector<double> diagonals;
  for (const geom::Box& box : boxes) {
    if (!box.empty() && box.diagonal() > 0) diagonals.push_back(box.diagonal());
  }
  basis.median_object_diagonal = median(std::move(diagonals));
  return basis;
}

}  // namespace rad::scene
