#include "report/html/model_view.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <set>

#include "bake/fault_painter.h"
#include "bake/png.h"
#include "report/listed_findings.h"

namespace rad::report::html {
namespace {

using bake::DrawnTriangle;
using scene::Finding;
using Listed = std::vector<const Finding*>;

constexpr std::uint32_t kSamplesPerAxis = 2;
// Stretches of triangles that a page highlights for one finding.
constexpr std::size_t kStretches = 4096;

std::vector<bool> faces_at_fault(const scene::Scene& scene, const Listed& findings) {
  std::vector<bool> at_fault(scene.faces.size(), false);
  for (const Finding* finding : findings) {
    for (const scene::FaceId face : finding->where.face_ids) at_fault[face] = true;
  }
  return at_fault;
}

double doubled_area(const scene::Scene& scene, const DrawnTriangle& triangle) {
  const geom::dvec3& a = scene.vertices[triangle.corners[0]];
  return glm::length(glm::cross(scene.vertices[triangle.corners[1]] - a, scene.vertices[triangle.corners[2]] - a));
}

/// In the order of the faces.
std::vector<DrawnTriangle> shown_triangles(const scene::Scene& scene, std::span<const DrawnTriangle> all,
                                           const Listed& findings) {
  if (all.size() <= kShownTriangles) return {all.begin(), all.end()};
  const std::vector<bool> at_fault = faces_at_fault(scene, findings);
  std::vector<double> rank(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) rank[i] = doubled_area(scene, all[i]);
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto first = [&](std::uint32_t x, std::uint32_t y) {
    const bool x_at_fault = at_fault[all[x].face], y_at_fault = at_fault[all[y].face];
    if (x_at_fault != y_at_fault) return x_at_fault;
    return rank[x] != rank[y] ? rank[x] > rank[y] : x < y;
  };
  std::nth_element(order.begin(), order.begin() + kShownTriangles, order.end(), first);
  order.resize(kShownTriangles);
  std::ranges::sort(order);
  std::vector<DrawnTriangle> shown;
  for (const std::uint32_t i : order) shown.push_back(all[i]);
  return shown;
}

std::vector<std::pair<std::size_t, std::size_t>> stretches(std::span<const DrawnTriangle> triangles,
                                                           const std::vector<scene::FaceId>& faces) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const scene::FaceId face : faces) {
    const auto range = std::ranges::equal_range(triangles, face, {}, &DrawnTriangle::face);
    if (range.empty()) continue;
    const auto first = static_cast<std::size_t>(range.begin() - triangles.begin());
    if (!result.empty() && result.back().first + result.back().second == first) {
      result.back().second += range.size();
    } else if (result.size() < kStretches) {
      result.emplace_back(first, range.size());
    } else {
      break;
    }
  }
  return result;
}

Picture taken(const bake::FaultPainter& painter, std::uint32_t width, std::uint32_t height, const bake::Camera& camera,
              std::span<const bake::DrawnFault> faults) {
  bake::FaultPicture picture;
  picture.width = width;
  picture.height = height;
  picture.samples_per_axis = kSamplesPerAxis;
  picture.camera = camera;
  return {bake::png_bytes(painter.picture(picture, faults)), width, height};
}

// Notes would hide the rest where they are many.
std::vector<bake::DrawnFault> worst_of(const Listed& findings) {
  std::vector<bake::DrawnFault> faults;
  for (auto it = findings.rbegin(); it != findings.rend(); ++it) {
    if ((*it)->severity == findings.front()->severity) faults.push_back(bake::drawn(**it));
  }
  return faults;
}

std::vector<FaultView> fault_views(const bake::FaultPainter& painter, std::span<const DrawnTriangle> shown,
                                   const Listed& findings) {
  std::vector<FaultView> views;
  std::set<std::string_view> pictured;
  for (const Finding* finding : findings) {
    FaultView view;
    view.camera = painter.close_up(*finding, kFaultAspect);
    view.triangles = stretches(shown, finding->where.face_ids);
    if (view.camera && pictured.size() < kFaultPictures && pictured.insert(finding->rule).second) {
      const bake::DrawnFault fault = bake::drawn(*finding);
      view.picture = taken(painter, kFaultWidth, kFaultHeight, *view.camera, {&fault, 1});
    }
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace

std::size_t size_of(const ModelView& view) {
  std::size_t bytes = view.geometry.bytes.size() + view.overview.png.size();
  for (const FaultView& fault : view.faults) bytes += fault.picture.png.size();
  return bytes;
}

std::optional<ModelView> model_view(const scene::Scene& scene, const InputReport& input, std::size_t max_issues) {
  const bake::FaultPainter painter(scene);
  if (painter.triangles().empty()) return std::nullopt;
  const Listed findings = listed_findings(input, max_issues);
  const std::vector<DrawnTriangle> shown = shown_triangles(scene, painter.triangles(), findings);
  ModelView view;
  view.up = bake::up_direction(scene);
  view.camera = bake::automatic_camera(scene, kOverviewAspect);
  view.geometry = packed(scene, shown);
  view.triangles = shown.size();
  view.left_out = painter.triangles().size() - shown.size();
  view.overview = taken(painter, kOverviewWidth, kOverviewHeight, view.camera, worst_of(findings));
  view.faults = fault_views(painter, shown, findings);
  return view;
}

}  // namespace rad::report::html
