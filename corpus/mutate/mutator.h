// Planting one known defect into a clean scene, far from whatever it does not concern.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/mutate/survey.h"

namespace rad::corpus {

/// Ground truth: where a finding of the rule is right. Defects in a text have lines, the others a region.
struct Planted {
  geom::Box region;                  ///< file units
  std::vector<FaceId> faces;         ///< of the scene with the defect
  std::vector<std::uint64_t> lines;  ///< 1-based
  bool whole_model = false;          ///< a finding without a place is right; with a region, the model lies there now
};

struct Mutant {
  scene::Scene scene;
  Planted planted;
};

/// `implied` are other rules that rightly speak in the same place, because the defect cannot be had without them.
struct Mutator {
  std::string_view name;
  std::string_view rule;
  std::span<const std::string_view> implied;
  /// Nothing where the scene has no place for this defect.
  std::optional<Mutant> (*plant)(const Survey& survey, Random& random) = nullptr;
  double noise = 0;  ///< how far it moves what it leaves, T
};

struct TextMutant {
  std::string obj;
  Planted planted;
};

/// The same for what only the text of a file can have.
struct TextMutator {
  std::string_view name;
  std::string_view rule;
  std::span<const std::string_view> implied;
  std::optional<TextMutant> (*plant)(std::string_view obj, Random& random) = nullptr;
};

/// A file of luminous intensities, sound and with a defect. Equal random numbers make the same lamp.
struct PhotometryMutator {
  std::string_view name;
  std::string_view rule;
  std::string_view suffix;  ///< of the file, with dot
  std::string (*sound)(Random& random) = nullptr;
  std::string (*spoiled)(Random& random) = nullptr;
};

std::span<const PhotometryMutator> photometry_mutators();
std::span<const Mutator> mutators();
std::span<const TextMutator> text_mutators();

// The lists that mutators() joins: defects of edges and orientation, of single faces, of faces with each other, of
// vertices and solids, as small as the tolerance, of connected surfaces, of materials and lights, of unit and place.
std::span<const Mutator> edge_mutators();
std::span<const Mutator> face_mutators();
std::span<const Mutator> contact_mutators();
std::span<const Mutator> solid_mutators();
std::span<const Mutator> fine_mutators();
std::span<const Mutator> surface_mutators();
std::span<const Mutator> material_mutators();
std::span<const Mutator> unit_mutators();

/// Defects all over a model, which make more findings than the one they are named by: for measuring repair. Their
/// region is empty. `rule` is one that speaks where there is something of the kind in the model.
std::span<const Mutator> model_mutators();

/// The item at which `plants` first succeeds, trying all from a random one on; nothing where none does.
template <typename Items, typename Plant>
auto first_that_plants(const Items& items, Random& random, Plant plant) -> decltype(plant(items[0])) {
  if (items.empty()) return std::nullopt;
  const std::size_t start = random.index(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (auto mutant = plant(items[(start + i) % items.size()])) return mutant;
  }
  return std::nullopt;
}

std::vector<FaceId> all_faces(const Survey& survey);

/// Whether a point may lie in the matter of a solid, where it is dark: in the box of an outward closed object.
bool may_be_in_matter(const Survey& survey, const dvec3& point);

/// Survey::free_spot() that does not; nothing where none is found.
std::optional<Spot> spot_in_air(const Survey& survey, Random& random, double clearance);

/// T of a scene, file units.
double tolerance_of(const scene::Scene& scene);

geom::Box ball_box(const dvec3& centre, double radius);

}  // namespace rad::corpus
