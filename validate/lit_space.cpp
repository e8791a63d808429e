#include "validate/lit_space.h"

#include <algorithm>

namespace rad::validate {
namespace {

class Lighting {
 public:
  Lighting(const Context& context, LitSpace& space) : context_(context), space_(space) {}

  void run() {
    space_.lit.assign(space_.cells.size(), false);
    space_.may_be_lit.assign(space_.cells.size(), false);
    seed_from_emitters();
    if (!space_.has_emitters) take_rooms_and_open_space_for_lit();
  }

 private:
  [[nodiscard]] bool emits(FaceId face) const {
    return face != kNoFace && context_.scene.materials[context_.material_of(face)].emits();
  }
  [[nodiscard]] std::uint32_t component(FaceId face) const { return context_.topology.component_of_face[face]; }

  void seed_from_emitters() {
    for (std::uint32_t t = 0; t < space_.sheets.size(); ++t) {
      for (const int side : {0, 1}) {
        const FaceId front = space_.sheets.front[t][side], back = space_.back(t, side);
        if (emits(front)) {
          space_.has_emitters = true;
          space_.lit[space_.cell(t, side)] = space_.may_be_lit[space_.cell(t, side)] = true;
        }
        if (emits(back) && !context_.topology.components[component(back)].closed()) {
          space_.may_be_lit[space_.cell(t, side)] = true;
        }
      }
    }
  }

  // Areas are summed as exact integers so that the order of triangles does not matter.
  void take_rooms_and_open_space_for_lit() {
    std::vector<geom::Int128> fronts(space_.cells.size(), 0);
    for (std::uint32_t t = 0; t < space_.sheets.size(); ++t) {
      const auto area = static_cast<std::int64_t>(twice_area(t));
      for (const int side : {0, 1}) {
        fronts[space_.cell(t, side)] += space_.sheets.front[t][side] != kNoFace ? area : -area;
      }
    }
    for (CellId cell = 0; cell < space_.cells.size(); ++cell) {
      space_.lit[cell] = space_.may_be_lit[cell] = cell == kOpenSpace || fronts[cell] > 0;
    }
  }

  [[nodiscard]] double twice_area(std::uint32_t triangle) const {
    const auto& t = space_.sheets.triangles[triangle];
    const auto& points = context_.model.points;
    return geom::TrianglePlane(points[t[0]], points[t[1]], points[t[2]]).normal_length;
  }

  const Context& context_;
  LitSpace& space_;
};

}  // namespace

std::optional<LitSpace> find_lit_space(const Context& context) {
  std::optional<Sheets> sheets = conforming_sheets(context);
  if (!sheets) return std::nullopt;
  std::optional<AirCells> cells = find_air_cells(context.model.points, sheets->triangles);
  if (!cells) return std::nullopt;
  LitSpace space;
  space.sheets = std::move(*sheets);
  space.cells = std::move(*cells);
  Lighting(context, space).run();
  return space;
}

}  // namespace rad::validate
