#include "bench/repair_steps.h"

#include <numeric>

#include "bench/self_intersections.h"
#include "geom/tolerance.h"
#include "repair/leader_planes.h"
#include "repair/normaliser.h"
#include "repair/piece_loader.h"
#include "repair/weld.h"
#include "scene/lattice_model.h"
#include "validate/context.h"

namespace rad::bench {
namespace {

// As for the complex after snapping (repair/conform.cpp).
constexpr double kBand = 0.5;

repair::Soup soup_of(const scene::Scene& scene, const scene::LatticeModel& model) {
  repair::Soup soup;
  soup.points = model.points;
  for (scene::FaceId face = 0; face < scene.faces.size(); ++face) {
    const auto corners = model.corners_of(scene.loops[scene.faces[face].first_loop]);
    if (corners.size() != 3) continue;
    repair::SoupPiece piece{static_cast<std::uint32_t>(soup.edges.size()), 3, face, face};
    for (std::size_t k = 0; k < 3; ++k) soup.edges.push_back({corners[k], corners[(k + 1) % 3]});
    if (soup.normal_of(piece) != geom::dvec3(0, 0, 0)) soup.pieces.push_back(piece);
  }
  return soup;
}

void time_insertion(const repair::Soup& soup, double tolerance, StepTimes& times) {
  times.triangles = soup.pieces.size();
  std::vector<std::uint32_t> pieces(soup.pieces.size());
  std::iota(pieces.begin(), pieces.end(), 0u);
  repair::Complex complex(tolerance);
  repair::Triangulation triangulation;
  for (const repair::PieceId id : pieces) {
    const auto edges = soup.edges_of(soup.pieces[id]);
    triangulation.add_as_it_is({edges[0][0], edges[1][0], edges[2][0]}, id);
  }
  repair::PieceLoader loader(soup, std::vector<std::uint8_t>(pieces.size(), 1), complex, triangulation);
  const repair::Soup part = part_of(soup, pieces);
  loader.load(part, pieces, claim_planes(part, kBand * tolerance, tolerance));
  const double start = cpu_seconds();
  repair::Normaliser(complex).run(complex.weld_distance());
  times.insert = cpu_seconds() - start;
  times.splits = complex.counts().splits;
}

}  // namespace

StepTimes time_steps(const scene::Scene& scene) {
  const scene::LatticeModel model = scene::build_lattice_model(scene);
  std::string refusal;
  const auto chosen = validate::chosen_tolerance(scene, model, std::nullopt, refusal);
  if (!chosen) return {};
  const auto tolerance = static_cast<double>(chosen->pitches);
  std::vector<geom::LatticePoint> points;
  for (const scene::PointId corner : model.corners) {
    if (corner != scene::kNoPoint) points.push_back(model.points[corner]);
  }
  StepTimes times;
  times.corners = points.size();
  const double start = cpu_seconds();
  repair::weld(points, tolerance);
  times.weld = cpu_seconds() - start;
  time_insertion(soup_of(scene, model), tolerance, times);
  return times;
}

}  // namespace rad::bench
