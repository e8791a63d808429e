// Defects all over a model, as exports and hand edits leave them. They trigger too many findings at once to measure
// rules by, and serve to measure repair.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"
#include "geom/tolerance.h"
#include "scene/lattice_model.h"

namespace rad::corpus {
namespace {

double tolerance_of(const Survey& survey) {
  const scene::LatticeModel model = scene::build_lattice_model(survey.scene());
  return geom::default_tolerance(scene::tolerance_basis(survey.scene(), model)).length;
}

dvec3 random_direction(Random& random) {
  while (true) {
    const double x = random.real(-1, 1), y = random.real(-1, 1);
    const dvec3 v(x, y, random.real(-1, 1));
    const double length = glm::length(v);
    if (length > 0.1 && length <= 1) return v / length;
  }
}

Mutant everywhere(const Draft& draft) { return {draft.scene(), {}}; }

// Gives every corner of every face a vertex of its own, off its place by between `low` and `high` T.
std::optional<Mutant> jittered(const Survey& survey, Random& random, double low, double high) {
  const double tolerance = tolerance_of(survey);
  Draft draft(survey.scene());
  for (DraftFace& face : draft.faces) {
    for (auto& loop : face.loops) {
      for (VertexId& corner : loop) {
        const double reach = random.real(low, high) * tolerance;
        corner = draft.add_vertex(survey.position(corner) + reach * random_direction(random));
      }
    }
  }
  return everywhere(draft);
}

std::optional<Mutant> little_noise(const Survey& survey, Random& random) { return jittered(survey, random, 0, 0.25); }
// Two corners of one vertex are up to 0.9 T apart: farther they would be two vertices.
std::optional<Mutant> much_noise(const Survey& survey, Random& random) { return jittered(survey, random, 0.25, 0.45); }

// Vertices themselves move, so that faces stay joined and lose their planes.
std::optional<Mutant> bent_faces(const Survey& survey, Random& random) {
  const double tolerance = tolerance_of(survey);
  Draft draft(survey.scene());
  for (VertexId id = 0; id < survey.scene().vertices.size(); ++id) {
    draft.vertex(id) += random.real(0.3, 0.9) * tolerance * random_direction(random);
  }
  return everywhere(draft);
}

// Ears of two triangles where that is convex; a triangle stays.
std::optional<Mutant> split_quads(const Survey& survey, Random& random) {
  Draft draft(survey.scene());
  const std::size_t count = draft.faces.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (draft.faces[i].loops.size() > 1 || draft.faces[i].loops[0].size() != 4) continue;
    auto ring = draft.faces[i].loops[0];
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random.index(2)), ring.end());
    DraftFace half = draft.faces[i];
    draft.faces[i].loops[0] = {ring[0], ring[1], ring[2]};
    half.loops[0] = {ring[0], ring[2], ring[3]};
    draft.faces.push_back(std::move(half));
  }
  return draft.faces.size() == count ? std::nullopt : std::optional(everywhere(draft));
}

std::optional<Mutant> all_twice(const Survey& survey, Random& /*random*/) {
  Draft draft(survey.scene());
  const std::vector<DraftFace> originals = draft.faces;
  draft.faces.insert(draft.faces.end(), originals.begin(), originals.end());
  return everywhere(draft);
}

std::optional<Mutant> all_twice_moved(const Survey& survey, const dvec3& by) {
  Draft draft(survey.scene());
  std::vector<DraftFace> copies = draft.faces;
  for (DraftFace& face : copies) {
    for (auto& loop : face.loops) {
      for (VertexId& corner : loop) corner = draft.add_vertex(survey.position(corner) + by);
    }
  }
  draft.faces.insert(draft.faces.end(), copies.begin(), copies.end());
  return everywhere(draft);
}

std::optional<Mutant> all_twice_offset(const Survey& survey, Random& random) {
  constexpr double kOffset = 1e-6;
  return all_twice_moved(survey, kOffset * random_direction(random));
}

std::optional<Mutant> all_twice_third(const Survey& survey, Random& random) {
  return all_twice_moved(survey, 0.3 * tolerance_of(survey) * random_direction(random));
}

// Every second object with vertices of its own one lattice pitch off.
std::optional<Mutant> lattice_step(const Survey& survey, Random& random) {
  const double pitch = scene::build_lattice_model(survey.scene()).lattice.pitch;
  Draft draft(survey.scene());
  std::vector<scene::ObjectId> moved;
  for (scene::ObjectId id = 0; id < survey.objects().size(); ++id) {
    if (!survey.objects()[id].faces.empty() && !survey.objects()[id].alone && random.one_in(2)) moved.push_back(id);
  }
  if (moved.empty()) return std::nullopt;
  for (const scene::ObjectId id : moved) {
    const dvec3 by = pitch * dvec3(random.between(-1, 1), random.between(-1, 1), 1);
    for (const FaceId face : survey.objects()[id].faces) {
      for (auto& loop : draft.faces[face].loops) {
        for (VertexId& corner : loop) corner = draft.add_vertex(survey.position(corner) + by);
      }
    }
  }
  return everywhere(draft);
}

// Of every edge between two faces one side gets a vertex in the middle.
std::optional<Mutant> t_vertices(const Survey& survey, Random& random) {
  struct Insertion {
    EdgeUse use;
    dvec3 middle;
  };
  std::vector<Insertion> insertions;
  for (const Edge& edge : survey.edges()) {
    const dvec3 a = survey.position(edge.a), b = survey.position(edge.b);
    if (edge.uses.size() == 2 && glm::distance(a, b) > survey.grain()) {
      insertions.push_back({edge.uses[random.index(2)], (a + b) * 0.5});
    }
  }
  // From the last corner on, so that those before keep their numbers.
  std::ranges::sort(insertions, std::greater{}, [](const Insertion& i) { return i.use.corner; });
  Draft draft(survey.scene());
  for (const auto& [use, middle] : insertions) {
    auto& loop = draft.faces[use.face].loops[use.loop];
    loop.insert(loop.begin() + use.corner + 1, draft.add_vertex(middle));
  }
  return insertions.empty() ? std::nullopt : std::optional(everywhere(draft));
}

// Of every closed object some faces, less than half of its area.
std::optional<Mutant> flipped_faces(const Survey& survey, Random& random) {
  Draft draft(survey.scene());
  bool flipped = false;
  for (const ObjectFacts& object : survey.objects()) {
    if (!object.closed || object.volume <= 0 || object.faces.size() < 6) continue;
    for (int count = 0; count < 2; ++count) {
      const FaceId face = object.faces[random.index(object.faces.size())];
      if (!survey.is_private(face)) continue;
      reverse(draft.faces[face]);
      flipped = true;
    }
  }
  return flipped ? std::optional(everywhere(draft)) : std::nullopt;
}

}  // namespace

std::span<const Mutator> model_mutators() {
  static constexpr std::array<Mutator, 10> kMutators{{
      {"all corners off by up to T/4", "RL302", {}, little_noise, 0.25},
      {"all corners up to 0.9 T apart", "RL302", {}, much_noise, 0.45},
      {"all vertices off by 0.3 to 0.9 T", "RL008", {}, bent_faces, 0.9},
      {"quads split in triangles", "RL120", {}, split_quads},
      {"all faces twice", "RL220", {}, all_twice},
      {"all faces twice, 1e-6 apart", "RL220", {}, all_twice_offset},
      {"all faces twice, 0.3 T apart", "RL220", {}, all_twice_third, 0.3},
      {"objects off by a lattice step", "RL302", {}, lattice_step},
      {"t-vertices on all edges", "RL301", {}, t_vertices},
      {"faces of all solids turned over", "RL110", {}, flipped_faces},
  }};
  return kMutators;
}

}  // namespace rad::corpus
