// What every writer gets and gives.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/light_map.h"
#include "scene/scene.h"
#include "scene/vertex_light.h"

namespace rad::writers {

/// A colour of the output and what it stands for.
struct LegendEntry {
  std::string_view name;  ///< of a material
  std::string_view meaning;
  geom::dvec3 colour{0, 0, 0};  ///< linear
};

struct Output {
  const scene::Scene& scene;
  const scene::VertexLight* light = nullptr;      ///< written where the format carries light
  const scene::LightMap* light_map = nullptr;     ///< with light: shown in place of its colours (glTF)
  std::optional<scene::RecordedLattice> lattice;  ///< recorded in the file; vertices on it keep their exact places
  std::span<const std::string> comments;          ///< one line each, without a mark of comment
  std::span<const LegendEntry> legend;            ///< written where the format has a place for it (glTF)
  bool marked_incomplete = false;                 ///< the file says that it is not what was asked for
};

/// Why nothing was written; empty where all was.
struct WriteResult {
  std::string problem;
  [[nodiscard]] bool ok() const { return problem.empty(); }
};

/// What keeps an output from being written in any format: no face with a corner, or light that does not fit the
/// vertices or is not finite, or a light map that does not fit the faces. Empty where nothing does.
std::string problem_of(const Output& output);

}  // namespace rad::writers
