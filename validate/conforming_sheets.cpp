#include "validate/conforming_sheets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "geom/box_tree.h"
#include "geom/triangle_meeting.h"

namespace rad::validate {
namespace {

using geom::ContactKind;
using Edge = std::array<PointId, 2>;

// Edges of a face's loops, ascending, without those that it runs along to and fro.
std::vector<Edge> outline_of(const Context& context, FaceId face) {
  std::vector<Edge> edges;
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
    const auto corners = context.model.corners_of(loop);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const PointId a = corners[i], b = corners[(i + 1) % corners.size()];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> outline;
  for (const Edge& edge : edges) {
    if (!outline.empty() && outline.back() == edge) {
      outline.pop_back();
    } else {
      outline.push_back(edge);
    }
  }
  return outline;
}

bool only_whole_contacts(const Context& context) {
  if (context.contacts.truncated || !context.contacts.vertices_on_edges.empty()) return false;
  if (!context.contacts.near_vertices.empty()) return false;
  const auto& conditions = context.triangles.condition;
  if (std::ranges::any_of(
          conditions, [](FaceCondition c) { return c == FaceCondition::RingCrosses || c == FaceCondition::LeftOut; })) {
    return false;
  }
  return std::ranges::all_of(context.contacts.faces, [&](const FaceContact& contact) {
    return contact.kind == ContactKind::Overlap && !contact.same_facing &&
           outline_of(context, contact.a) == outline_of(context, contact.b);
  });
}

class SheetBuilder {
 public:
  explicit SheetBuilder(const Context& context) : context_(context), other_(context.scene.faces.size(), kNoFace) {}

  std::optional<Sheets> run() {
    if (!only_whole_contacts(context_)) return std::nullopt;
    find_first_triangles();
    for (const FaceContact& contact : context_.contacts.faces) {
      if (!pair_up(contact.a, contact.b)) return std::nullopt;
    }
    for (FaceId face = 0; face < context_.scene.faces.size(); ++face) add_face(face);
    return meets_nowhere_else() ? std::optional(std::move(sheets_)) : std::nullopt;
  }

 private:
  void find_first_triangles() {
    const auto& all = context_.triangles.triangles;
    first_.assign(context_.scene.faces.size() + 1, 0);
    for (const FaceTriangle& triangle : all) ++first_[triangle.face + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  }

  // Of two faces on each other both are cut the way that comes first in space.
  bool pair_up(FaceId a, FaceId b) {
    if (other_[a] != kNoFace || other_[b] != kNoFace) return false;
    const bool in_order = places_of(a) <= places_of(b);
    other_[in_order ? a : b] = in_order ? b : a;
    other_[in_order ? b : a] = kCovered;
    return true;
  }

  [[nodiscard]] std::vector<std::array<PointId, 3>> places_of(FaceId face) const {
    std::vector<std::array<PointId, 3>> places;
    for (std::uint32_t i = first_[face]; i < first_[face + 1]; ++i) {
      places.push_back(context_.triangles.triangles[i].points);
      std::sort(places.back().begin(), places.back().end());
    }
    std::sort(places.begin(), places.end());
    return places;
  }

  void add_face(FaceId face) {
    if (other_[face] == kCovered) return;
    for (std::uint32_t i = first_[face]; i < first_[face + 1]; ++i) {
      sheets_.triangles.push_back(context_.triangles.triangles[i].points);
      sheets_.front.push_back({face, other_[face]});
    }
  }

  [[nodiscard]] std::array<geom::LatticePoint, 3> corners_of(std::uint32_t triangle) const {
    const auto& t = sheets_.triangles[triangle];
    return {context_.model.points[t[0]], context_.model.points[t[1]], context_.model.points[t[2]]};
  }

  // What is left of contacts shorter than T, which the tolerance hides.
  [[nodiscard]] bool meets_nowhere_else() const {
    constexpr std::uint32_t kSlotsPerBlock = 1024;
    std::vector<geom::LatticeBox> boxes(sheets_.size());
    tbb::parallel_for(std::size_t{0}, boxes.size(),
                      [&](std::size_t i) { boxes[i] = geom::box_of(corners_of(static_cast<std::uint32_t>(i))); });
    const geom::BoxTree tree(std::move(boxes));
    const auto slots = static_cast<std::uint32_t>(tree.size());
    std::atomic<bool> meets = false;
    tbb::parallel_for(std::uint32_t{0}, (slots + kSlotsPerBlock - 1) / kSlotsPerBlock, [&](std::uint32_t block) {
      const std::uint32_t end = std::min(slots, (block + 1) * kSlotsPerBlock);
      for (std::uint32_t slot = block * kSlotsPerBlock; slot < end && !meets; ++slot) {
        tree.for_each_later_meeting(slot, slot + 1, [&](std::uint32_t i, std::uint32_t j) {
          if (geom::meet_beyond_shared_corners(corners_of(i), corners_of(j))) meets = true;
        });
      }
    });
    return !meets;
  }

  static constexpr FaceId kCovered = kNoFace - 1;

  const Context& context_;
  std::vector<FaceId> other_;         ///< per face: the one that lies on it, kCovered where that one stands for both
  std::vector<std::uint32_t> first_;  ///< per face, into Context::triangles; one more than there are faces
  Sheets sheets_;
};

}  // namespace

std::optional<Sheets> conforming_sheets(const Context& context) { return SheetBuilder(context).run(); }

}  // namespace rad::validate
