#include "validate/grouping.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <numeric>
#include <tuple>

#include "scene/disjoint_sets.h"
#include "validate/fingerprint.h"
#include "validate/message.h"

namespace rad::validate {
namespace {

using scene::Finding;
using scene::Scene;
using scene::Severity;

/// Objects and materials of a violation, ascending: equal for the same participants in either order.
struct Participants {
  std::array<std::uint32_t, 2> objects{kNoFace, kNoFace};
  std::array<std::uint32_t, 2> materials{kNoFace, kNoFace};

  friend auto operator<=>(const Participants&, const Participants&) = default;
};

Participants participants_of(const Violation& violation, const Scene& scene) {
  Participants result;
  for (int i = 0; i < 2; ++i) {
    if (violation.faces[i] == kNoFace) continue;
    result.objects[i] = scene.faces[violation.faces[i]].object;
    result.materials[i] = scene.faces[violation.faces[i]].material;
  }
  std::sort(result.objects.begin(), result.objects.end());
  std::sort(result.materials.begin(), result.materials.end());
  return result;
}

auto flat(const dvec3& p) { return std::array{p.x, p.y, p.z}; }
auto flat(const std::optional<dvec3>& p) { return flat(p.value_or(dvec3{0, 0, 0})); }

// Worse first; ties by place, so that the order of faces never decides.
bool leads(const Rule& rule, const Violation& x, const Violation& y) {
  if (x.measure != y.measure) return rule.measure.smaller_is_worse ? x.measure < y.measure : x.measure > y.measure;
  if (flat(x.point) != flat(y.point)) return flat(x.point) < flat(y.point);
  const auto ends = [](const Violation& v) {
    return v.segment ? std::array{flat((*v.segment)[0]), flat((*v.segment)[1])}
                     : std::array{flat(v.point), flat(v.point)};
  };
  if (ends(x) != ends(y)) return ends(x) < ends(y);
  return x.faces < y.faces;
}

using Cluster = std::vector<std::uint32_t>;  // indices of violations

// What links two violations: equal participants and an equal cluster key or face.
struct Link {
  std::uint32_t participants = 0;
  std::uint64_t key = 0;
  std::uint32_t violation = 0;

  [[nodiscard]] bool same_place(const Link& other) const {
    return participants == other.participants && key == other.key;
  }
  friend bool operator<(const Link& a, const Link& b) {
    return std::tie(a.participants, a.key, a.violation) < std::tie(b.participants, b.key, b.violation);
  }
};

std::vector<Link> links_of(const Violations& violations, const Scene& scene) {
  std::map<Participants, std::uint32_t> numbers;
  std::vector<Link> links;
  links.reserve(2 * violations.items.size());
  constexpr std::uint32_t kAnyone = 0xffffffffu;
  constexpr std::uint64_t kFaceKey = std::uint64_t{1} << 63;  // keeps faces apart from cluster keys
  for (std::uint32_t i = 0; i < violations.items.size(); ++i) {
    const Violation& item = violations.items[i];
    if (item.cluster == kWholeModel) {
      links.push_back({kAnyone, kWholeModel, i});
      continue;
    }
    const auto next = static_cast<std::uint32_t>(numbers.size());
    const std::uint32_t number = numbers.emplace(participants_of(item, scene), next).first->second;
    if (item.cluster != 0) {
      links.push_back({number, item.cluster, i});
      continue;
    }
    for (const FaceId face : item.faces) {
      if (face != kNoFace) links.push_back({number, kFaceKey | face, i});
    }
  }
  tbb::parallel_sort(links.begin(), links.end());
  return links;
}

std::vector<Cluster> clusters_of(const Violations& violations, const Scene& scene, bool group) {
  const auto count = static_cast<std::uint32_t>(violations.items.size());
  scene::DisjointSets sets(count);
  if (group) {
    const std::vector<Link> links = links_of(violations, scene);
    for (std::size_t i = 1; i < links.size(); ++i) {
      if (links[i].same_place(links[i - 1])) sets.unite(links[i].violation, links[i - 1].violation);
    }
  }
  // The representative of a set is its smallest member, so it comes before the others.
  std::vector<std::uint32_t> slot(count);
  std::vector<Cluster> clusters;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t root = sets.find(i);
    if (root == i) {
      slot[i] = static_cast<std::uint32_t>(clusters.size());
      clusters.emplace_back();
    }
    clusters[slot[root]].push_back(i);
  }
  return clusters;
}

void place_at_face(const Scene& scene, FaceId face, scene::Where& where) {
  const scene::SourceRef& source = scene.faces[face].source;
  if (source.section >= scene.sections.size()) return;
  const scene::SourceSection& section = scene.sections[source.section];
  where.file = section.file;
  if (section.kind == scene::RecordKind::Line) where.line = source.record;
  if (section.kind == scene::RecordKind::ByteOffset) where.byte_offset = source.record;
  where.pointer = scene::reference_to(scene, face).pointer;
}

void place_at_vertex(const Scene& scene, scene::VertexId vertex, scene::Where& where) {
  if (scene.vertex_records.size() != scene.vertices.size() || scene.vertex_section >= scene.sections.size()) return;
  const scene::SourceSection& section = scene.sections[scene.vertex_section];
  where.file = section.file;
  if (section.kind == scene::RecordKind::Line) where.line = scene.vertex_records[vertex];
  if (section.kind == scene::RecordKind::ByteOffset) where.byte_offset = scene.vertex_records[vertex];
  if (section.kind == scene::RecordKind::Item) {
    where.pointer = section.pointer + "/" + std::to_string(scene.vertex_records[vertex]);
  }
}

// The different ids that faces have, ascending.
template <typename IdOf>
std::vector<std::uint32_t> ids_of(const std::vector<FaceId>& faces, IdOf id_of) {
  std::vector<std::uint32_t> ids;
  for (const FaceId face : faces) {
    // Neighbours in the file have mostly the same: few are left to sort.
    if (ids.empty() || ids.back() != id_of(face)) ids.push_back(id_of(face));
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void name_participants(const Scene& scene, const std::vector<FaceId>& faces, scene::Where& where) {
  for (const scene::ObjectId id : ids_of(faces, [&](FaceId face) { return scene.faces[face].object; })) {
    if (!scene.objects[id].empty()) where.objects.push_back(scene.objects[id]);
  }
  for (const scene::MaterialId id : ids_of(faces, [&](FaceId face) { return scene.faces[face].material; })) {
    if (!scene.materials[id].name.empty()) where.materials.push_back(scene.materials[id].name);
  }
  std::sort(where.objects.begin(), where.objects.end());
  std::sort(where.materials.begin(), where.materials.end());
}

// Lists faces in the order of the violations given, the worst ones; counts and names those of all.
void list_faces(const Scene& scene, const std::vector<const Violation*>& all, std::size_t worst, scene::Where& where) {
  std::vector<FaceId> faces;
  for (const Violation* violation : all) {
    for (const FaceId face : violation->faces) {
      if (face != kNoFace) faces.push_back(face);
    }
  }
  tbb::parallel_sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  where.face_count = faces.size();
  name_participants(scene, faces, where);
  std::vector<FaceId> listed;
  for (std::size_t i = 0; i < worst; ++i) {
    for (const FaceId face : all[i]->faces) {
      const bool fresh = std::find(listed.begin(), listed.end(), face) == listed.end();
      if (face != kNoFace && fresh && listed.size() < scene::kListedFaces) listed.push_back(face);
    }
  }
  for (const FaceId face : listed) where.faces.push_back(scene::reference_to(scene, face));
  where.face_ids = std::move(faces);
}

void list_places(const std::vector<const Violation*>& worst_first, std::size_t sorted, scene::Where& where) {
  for (std::size_t i = 0; i < sorted; ++i) {
    const Violation& violation = *worst_first[i];
    if (violation.point || violation.segment) where.places.push_back({violation.point, violation.segment});
  }
}

// Empty where no corner is sound.
geom::Box box_of(const Context& context, FaceId face) {
  geom::Box box;
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
    for (const scene::PointId id : context.model.corners_of(loop)) {
      if (id != scene::kNoPoint) box.add(context.model.position(id));
    }
  }
  return box;
}

geom::Box common_part(const geom::Box& a, const geom::Box& b) {
  geom::Box box{glm::max(a.low, b.low), glm::min(a.high, b.high)};
  // Faces that touch within T may have boxes that do not meet.
  for (int axis = 0; axis < 3; ++axis) {
    if (box.low[axis] > box.high[axis]) std::swap(box.low[axis], box.high[axis]);
  }
  return box;
}

// Where a violation is, by what noise and the order of corners do not move: the ends of its segment; of an area that
// two faces share what their boxes have in common; of a fault of a whole face its box; else its point.
geom::Box extent_of(const Rule& rule, const Context& context, const Violation& violation) {
  geom::Box box;
  const bool one_face = violation.faces[0] != kNoFace && violation.faces[1] == kNoFace;
  if (violation.segment) {
    for (const dvec3& end : *violation.segment) box.add(end);
  } else if (violation.faces[1] != kNoFace && rule.measure.unit == MeasureUnit::Area) {
    box = common_part(box_of(context, violation.faces[0]), box_of(context, violation.faces[1]));
  } else if (one_face && violation.vertex == kNoVertex) {
    box = box_of(context, violation.faces[0]);
  }
  if (box.empty() && violation.point) box.add(*violation.point);
  return box;
}

std::optional<std::array<dvec3, 2>> bounds_of(const Rule& rule, const Context& context,
                                              const std::vector<const Violation*>& violations) {
  geom::Box box;
  for (const Violation* violation : violations) {
    const geom::Box extent = extent_of(rule, context, *violation);
    if (extent.empty()) continue;
    box.add(extent.low);
    box.add(extent.high);
  }
  if (box.empty()) return std::nullopt;
  return std::array{box.low, box.high};
}

// Summed from the smallest on, so that the order of violations does not show. Nothing where none has an area.
std::optional<double> area_of(const std::vector<const Violation*>& violations) {
  std::vector<double> areas;
  for (const Violation* violation : violations) {
    if (violation->area > 0) areas.push_back(violation->area);
  }
  if (areas.empty()) return std::nullopt;
  std::sort(areas.begin(), areas.end());
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

// Before there is a message: numbers in it change with the least noise.
void identify(const Context& context, Finding& finding) {
  const geom::Box frame = frame_of(context, finding.where.face_ids);
  if (!frame.empty()) finding.where.frame = frame.low;
  finding.fingerprint = fingerprint_of(finding, frame.empty() ? 0 : frame.diagonal(), context.tolerance.length);
}

Finding finding_of(const Rule& rule, const Severities& severities, const Context& context, const Violations& violations,
                   const Cluster& cluster) {
  std::vector<const Violation*> ordered;
  for (const std::uint32_t index : cluster) ordered.push_back(&violations.items[index]);
  const std::size_t sorted = std::min(ordered.size(), scene::kDrawnPlaces);
  std::partial_sort(ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(sorted), ordered.end(),
                    [&](const Violation* x, const Violation* y) { return leads(rule, *x, *y); });
  const Violation& worst = *ordered.front();
  const bool grave = std::ranges::any_of(ordered, &Violation::grave);
  Finding finding = finding_frame(rule, grave ? severities.grave : severities.usual);
  finding.count = 0;
  for (const Violation* violation : ordered) finding.count += violation->count;
  finding.area = area_of(ordered);
  finding.kept_below = worst.kept_below;
  finding.where.file = context.scene.path;
  if (worst.faces[0] != kNoFace) place_at_face(context.scene, worst.faces[0], finding.where);
  if (worst.vertex != kNoVertex) place_at_vertex(context.scene, worst.vertex, finding.where);
  finding.where.point = worst.point;
  finding.where.segment = worst.segment;
  finding.where.bounds = bounds_of(rule, context, ordered);
  list_faces(context.scene, ordered, std::min(sorted, scene::kListedFaces), finding.where);
  list_places(ordered, sorted, finding.where);
  if (!rule.measure.name.empty()) {
    finding.measure =
        measure_of(rule, worst.measure, rule.threshold ? std::optional(rule.threshold(context)) : std::nullopt);
  }
  identify(context, finding);
  finding.message = message_of(rule, finding, worst.detail);
  return finding;
}

}  // namespace

std::vector<Finding> group_violations(const Rule& rule, const Severities& severities, const Context& context,
                                      const Violations& violations, bool group) {
  std::vector<Finding> findings;
  for (const Cluster& cluster : clusters_of(violations, context.scene, group)) {
    findings.push_back(finding_of(rule, severities, context, violations, cluster));
  }
  return findings;
}

Finding finding_of_issue(const Rule& rule, Severity severity, const Scene& scene, const scene::ReadIssue& issue) {
  Finding finding = finding_frame(rule, severity);
  finding.count = issue.count;
  finding.where.file = issue.place.file.empty() ? scene.path : issue.place.file;
  finding.where.line = issue.place.line;
  finding.where.byte_offset = issue.place.byte_offset;
  finding.where.pointer = issue.place.pointer;
  finding.message = message_of(rule, finding, issue.what);
  finding.fingerprint = fingerprint_of(finding, 0, 0);
  return finding;
}

void sort_findings(std::vector<Finding>& findings) {
  const auto key = [](const Finding& f) {
    const double measure = f.measure ? std::abs(f.measure->value) : 0;
    // Of faces that coincide either may be named: lines tell only those apart that have no place in space.
    const std::uint64_t line = f.where.point ? 0 : f.where.line;
    const std::uint64_t byte = f.where.point ? 0 : f.where.byte_offset.value_or(0);
    return std::tuple(-static_cast<int>(f.severity), f.rule, std::string_view(f.where.file), -measure,
                      flat(f.where.point), line, byte, std::string_view(f.message), std::string_view(f.fingerprint));
  };
  std::stable_sort(findings.begin(), findings.end(),
                   [&](const Finding& x, const Finding& y) { return key(x) < key(y); });
}

void number_equal_fingerprints(std::vector<Finding>& findings) {
  std::map<std::string, int> seen;
  for (Finding& finding : findings) {
    const int nth = ++seen[finding.fingerprint];
    if (nth > 1) finding.fingerprint += "-" + std::to_string(nth);
  }
}

}  // namespace rad::validate
