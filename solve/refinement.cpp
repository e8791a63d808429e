#include "solve/refinement.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/element_views.h"

namespace rad::solve {
namespace {

/// Share of what surfaces reflect in the mean below which it does not matter how exact the light is.
constexpr double kDarkShare = 0.1;

}  // namespace

Refinement::Refinement(Solution& solution, mesh::ElementMesh& elements, const RefineOptions& options,
                       const std::vector<bool>& whole)
    : solution_(solution),
      elements_(elements),
      options_(options),
      whole_(whole),
      first_leaf_(mesh::leaves_of_elements(elements)) {
  const Shooting& shooting = solution.shooting();
  double area = 0;
  for (mesh::PatchId patch = 0; patch < solution.radiators().patch.size(); ++patch) {
    shot_by_.push_back(shooting.shot_by(patch));
    const auto& at_local = shot_by_.back().at_local;
    if (std::ranges::all_of(at_local, [](const dvec3& value) { return value == dvec3(0); })) shot_by_.back() = {};
  }
  for (const Radiator& radiator : solution.radiators().patch) area += radiator.area;
  if (area > 0) usual_ = shooting.energy(1).reflected / area;
}

void Refinement::run(std::vector<dvec3>& radiosity, Progress& progress) {
  look_at_first_leaves(radiosity);
  for (std::uint32_t level = 0; level < options_.levels && !rough_.empty(); ++level) {
    const Shooting& shooting = solution_.shooting();
    if (!progress.go_on(shooting.unshot_share(), shooting.shots())) return;
    const std::size_t first = elements_.element_count();
    elements_.refine(chosen());
    look_at_new_leaves(first, mesh::radiosity_mesh(elements_), radiosity);
  }
}

dvec3 Refinement::radiosity_of(mesh::PatchId patch, const dvec3& irradiance) const {
  return solution_.shooting().emission(patch) + solution_.shooting().reflectance(patch) * irradiance;
}

/// In units of what is allowed: above 1 it is too rough.
double Refinement::roughness(const mesh::Corners& corners, const std::vector<dvec3>& radiosity,
                             const dvec3& centre) const {
  dvec3 mean{0, 0, 0};
  dvec3 low = radiosity[corners.node[0]], high = low;
  for (const mesh::NodeId node : corners.all()) {
    mean += radiosity[node] / static_cast<double>(corners.count);
    low = glm::min(low, radiosity[node]);
    high = glm::max(high, radiosity[node]);
  }
  double rough = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double dark = kDarkShare * usual_[channel];
    const double bend = options_.bend * (std::abs(centre[channel]) + dark);
    const double step = options_.contrast * (high[channel] + dark);
    if (bend > 0) rough = std::max(rough, std::abs(centre[channel] - mean[channel]) / bend);
    if (step > 0) rough = std::max(rough, (high[channel] - low[channel]) / step);
  }
  return rough;
}

double Refinement::edge_of(mesh::ElementId element, const mesh::RadiosityMesh& mesh) const {
  const mesh::Corners corners = elements_.corners(element);
  double longest = 0;
  for (std::uint32_t i = 0; i < corners.count; ++i) {
    const dvec3& a = mesh.nodes[corners.node[i]].position;
    const dvec3& b = mesh.nodes[corners.node[(i + 1) % corners.count]].position;
    longest = std::max(longest, glm::length(b - a));
  }
  return longest;
}

void Refinement::look_at(mesh::ElementId leaf, double roughness, const mesh::RadiosityMesh& mesh) {
  if (!(roughness > 1) || whole_[elements_.patch_of(leaf)]) return;
  const double edge = edge_of(leaf, mesh);
  if (edge / 2 >= options_.shortest_edge) rough_.push_back({leaf, roughness * edge * edge});
}

void Refinement::look_at_first_leaves(const std::vector<dvec3>& radiosity) {
  const mesh::RadiosityMesh& mesh = solution_.source().mesh;
  const Radiators& radiators = solution_.radiators();
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const mesh::PatchId patch = mesh.elements[i].patch;
    const std::size_t centre = radiators.patch[patch].first_local + radiators.element[i][kCentreShare];
    const dvec3 at_centre = radiosity_of(patch, solution_.shooting().irradiance().at(centre));
    look_at(first_leaf_[i], roughness(mesh.elements[i].corners, radiosity, at_centre), mesh);
  }
}

void Refinement::find_elements() {
  first_element_.assign(elements_.element_count(), 0);
  std::vector<mesh::ElementId> below;
  for (std::uint32_t i = static_cast<std::uint32_t>(first_leaf_.size()); i-- > 0;) below.push_back(first_leaf_[i]);
  for (std::uint32_t i = static_cast<std::uint32_t>(first_leaf_.size()); i-- > 0;) first_element_[first_leaf_[i]] = i;
  while (!below.empty()) {
    const mesh::ElementId element = below.back();
    below.pop_back();
    if (elements_.is_leaf(element)) continue;
    for (std::uint32_t k = 0; k < 4; ++k) {
      first_element_[elements_.first_child(element) + k] = first_element_[element];
      below.push_back(elements_.first_child(element) + k);
    }
  }
}

/// Of the pieces of the leaf that `leaf` came from, the one that the point lies in, or nearest to.
std::uint32_t Refinement::element_at(mesh::ElementId leaf, const dvec3& point) const {
  const mesh::RadiosityMesh& mesh = solution_.source().mesh;
  const std::uint32_t first = first_element_[leaf];
  std::uint32_t best = first;
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = first; i < first_leaf_.size() && first_leaf_[i] == first_leaf_[first]; ++i) {
    const Stratum piece = stratum_of(mesh.elements[i].corners, mesh);
    const auto [u, v] = place_in(piece, point);
    const double depth = piece.count == 3 ? std::min({u, v, 1 - u - v}) : std::min({u, v, 1 - u, 1 - v});
    if (depth > deepest) {
      deepest = depth;
      best = i;
    }
  }
  return best;
}

std::vector<Refinement::Wanted> Refinement::wanted(std::size_t first, std::size_t known,
                                                   const mesh::RadiosityMesh& mesh) const {
  std::vector<Wanted> wanted;
  std::vector<bool> seen(mesh.nodes.size() - known, false);
  const std::vector<mesh::ElementId> leaf_of = mesh::leaves_of_elements(elements_);
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    for (const mesh::NodeId node : mesh.elements[i].corners.all()) {
      if (node < known || seen[node - known]) continue;
      seen[node - known] = true;
      wanted.push_back({element_at(leaf_of[i], mesh.nodes[node].position), node, mesh::kNoElement});
    }
  }
  for (auto leaf = static_cast<mesh::ElementId>(first); leaf < elements_.element_count(); ++leaf) {
    if (!elements_.is_leaf(leaf)) continue;
    wanted.push_back({element_at(leaf, stratum_of(elements_.corners(leaf), mesh).centre()), 0, leaf});
  }
  std::ranges::stable_sort(wanted, {}, &Wanted::element);
  return wanted;
}

Receiver Refinement::receiver_of(const Wanted& wanted, const mesh::RadiosityMesh& mesh) const {
  const double lift = solution_.source().lift;
  if (wanted.leaf == mesh::kNoElement) return receiver_at(mesh.nodes[wanted.node], mesh.tolerance, lift);
  const dvec3& normal = mesh.patches[patch_of(wanted)].normal;
  return {stratum_of(elements_.corners(wanted.leaf), mesh).centre() + normal * lift, normal};
}

void Refinement::look_at_new_leaves(std::size_t first, const mesh::RadiosityMesh& mesh, std::vector<dvec3>& radiosity) {
  find_elements();
  const std::vector<Wanted> all = wanted(first, radiosity.size(), mesh);
  std::vector<ReplayPoint> points;
  points.reserve(all.size());
  for (const Wanted& wanted : all) points.push_back({receiver_of(wanted, mesh), wanted.element});
  const std::vector<dvec3> irradiance =
      replay(solution_.source(), solution_.couplings(), solution_.shooting().irradiance(), shot_by_, points);
  radiosity.resize(mesh.nodes.size(), dvec3(0));
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].leaf == mesh::kNoElement) radiosity[all[i].node] = radiosity_of(patch_of(all[i]), irradiance[i]);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].leaf == mesh::kNoElement) continue;
    const dvec3 at_centre = radiosity_of(patch_of(all[i]), irradiance[i]);
    look_at(all[i].leaf, roughness(elements_.corners(all[i].leaf), radiosity, at_centre), mesh);
  }
}

/// The roughest where there would be too many; each division makes three more.
std::vector<mesh::ElementId> Refinement::chosen() {
  std::ranges::sort(rough_, {}, &Rough::element);
  const auto same = std::ranges::unique(rough_, {}, &Rough::element);
  rough_.erase(same.begin(), same.end());
  if (options_.most_elements > 0) {
    const std::size_t now = elements_.leaves().size();
    const std::size_t most = options_.most_elements > now ? (options_.most_elements - now) / 3 : 0;
    if (rough_.size() > most) {
      std::ranges::stable_sort(rough_, std::greater{}, &Rough::gain);
      rough_.resize(most);
    }
  }
  std::vector<mesh::ElementId> elements;
  for (const Rough& rough : rough_) elements.push_back(rough.element);
  rough_.clear();
  return elements;
}

}  // namespace rad::solve
