// Which surface is visible where several overlap: one total order of all surfaces, so that any number of layers and any
// partial overlaps come out the same way (paper 3.3: the face from the larger surface is removed).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "validate/context.h"

namespace rad::repair {

enum class CoplanarPolicy : std::uint8_t {
  Paper,      ///< emitters before others, then the smaller surface
  Area,       ///< the smaller surface, whether it emits or not
  Priority,   ///< what --priority and decals say; nothing else of meaning
  KeepFirst,  ///< the surface that comes first in the file
  KeepLast,   ///< the one that comes last, as if painted over the others
};

/// The policy by the name that a user gives it: paper, area, priority, keep-first, keep-last.
std::optional<CoplanarPolicy> parse_coplanar_policy(std::string_view name);

struct CoplanarOptions {
  CoplanarPolicy policy = CoplanarPolicy::Paper;
  std::vector<std::string> priority;  ///< shell patterns for names of materials and objects, highest first
  bool emitter_priority = true;       ///< of the policy Paper
};

/// What decided between two surfaces, by the letter that reports name it by.
enum class OrderRule : char {
  Priority = 'a',      ///< a pattern of CoplanarOptions::priority, or the word "decal" in the name
  Emitter = 'b',       ///< one of them emits
  Area = 'c',          ///< one of them is smaller
  SameMaterial = 'd',  ///< nothing that could be seen: both have one material
  Content = 'e',       ///< a tie: names, then all vertices
  FileOrder = 'f',     ///< the policy asks for the first or the last
};

/// A total order of the surfaces of a scene. Before all else go the patterns of the user, then what is called a decal;
/// then the criteria of the policy; then content, so that file order decides nothing unless the policy says so.
/// Areas of surfaces that overlap each other count as equal within 0.1 %: equal sheets must not change places for the
/// noise of their measures.
class SurfaceOrder {
 public:
  SurfaceOrder(const validate::Context& context, const CoplanarOptions& options);

  /// Per face the place of its surface in the order; the least is visible.
  [[nodiscard]] const std::vector<std::uint32_t>& ranks() const { return ranks_; }
  /// What put the surface of `winner` before that of `loser`.
  [[nodiscard]] OrderRule decided_by(scene::FaceId winner, scene::FaceId loser) const;

 private:
  struct Surface {
    std::size_t level = 0;  ///< of the first pattern that fits; the count of patterns and more where none does
    bool emits = false;
    double area = 0;        ///< pitches²
    double class_area = 0;  ///< least area of those that it overlaps and that are as large
    scene::MaterialId material = 0;
    std::string material_name;
    std::string object_name;
    std::uint64_t content = 0;  ///< hash of the vertices; only where another surface is as large
    scene::PointId smallest_point = scene::kNoPoint;
    scene::FaceId first = 0;  ///< in the file
    scene::FaceId last = 0;
  };

  void gather(const validate::Context& context, const CoplanarOptions& options);
  void find_equals(const validate::Context& context);
  void hash_contents(const validate::Context& context, std::span<const scene::FaceId> equals);
  void sort();
  [[nodiscard]] bool before(const Surface& a, const Surface& b) const;
  [[nodiscard]] bool by_file() const {
    return policy_ == CoplanarPolicy::KeepFirst || policy_ == CoplanarPolicy::KeepLast;
  }

  CoplanarPolicy policy_;
  bool emitters_first_;
  std::vector<std::uint32_t> surface_of_face_;
  std::vector<Surface> surfaces_;
  std::vector<std::uint32_t> ranks_;
};

}  // namespace rad::repair
