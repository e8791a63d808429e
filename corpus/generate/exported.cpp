#include "corpus/generate/exported.h"

#include <algorithm>

namespace rad::corpus {

Frame turned(Frame frame, int right_angles) {
  for (int i = 0; i < right_angles; ++i) {
    const Millimetres u = frame.axes[0], v = frame.axes[1];
    frame.axes[0] = v;
    frame.axes[1] = {-u.x, -u.y, -u.z};
  }
  return frame;
}

Frame moved(const Frame& frame, Planar place, int n) {
  Frame result = frame;
  result.origin = frame.at(place, n);
  return result;
}

Frame upright(const Frame& plan) {
  const auto& [u, v, n] = plan.axes;
  return {plan.origin, {u, n, {-v.x, -v.y, -v.z}}, plan.divisor};
}

void Exporter::begin(std::string_view kind) {
  const auto entry = counts_.try_emplace(std::string(kind), 0).first;
  modeller_.begin_object(std::string(kind) + "_" + std::to_string(++entry->second));
}

void Exporter::box(const Frame& frame, const Millimetres& low, const Millimetres& high) {
  prism(modeller_, frame, rectangle({low.x, low.y}, {high.x, high.y}), low.z, high.z);
}

void Exporter::post(const Frame& frame, Planar corner, int thickness, int low, int high) {
  box(frame, {corner.u, corner.v, low}, {corner.u + thickness, corner.v + thickness, high});
}

void Exporter::column(const Frame& frame, Planar centre, int radius, int low, int high) {
  prism(modeller_, frame, round_outline(centre, radius), low, high);
}

// Full strips beside the openings, short ones before and behind them: the corners of the short ones lie inside the
// edges of the full ones. Openings must not overlap along u.
void Exporter::cut_sheet(const Frame& frame, Planar size, const std::vector<Opening>& openings, int n, Facing facing) {
  std::vector<Opening> sorted = openings;
  std::sort(sorted.begin(), sorted.end(), [](const Opening& a, const Opening& b) { return a.low.u < b.low.u; });
  const auto strip = [&](Planar low, Planar high) {
    if (low.u < high.u && low.v < high.v) panel(modeller_, frame, rectangle(low, high), n, facing);
  };
  int from = 0;
  for (const Opening& opening : sorted) {
    strip({from, 0}, {opening.low.u, size.v});
    strip({opening.low.u, 0}, {opening.high.u, opening.low.v});
    strip({opening.low.u, opening.high.v}, {opening.high.u, size.v});
    from = opening.high.u;
  }
  strip({from, 0}, size);
}

void Exporter::slab(const Frame& frame, Planar size, const std::vector<Opening>& openings, int low, int high) {
  cut_sheet(frame, size, openings, high, Facing::Along);
  cut_sheet(frame, size, openings, low, Facing::Against);
  sides(modeller_, frame, rectangle({0, 0}, size), low, high);
  for (const Opening& opening : openings) {
    sides(modeller_, frame, reversed(rectangle(opening.low, opening.high)), low, high);
  }
}

void Exporter::wall(const Frame& plan, int length, int thickness, int height, const std::vector<Opening>& openings) {
  const Frame front = upright(plan);
  cut_sheet(front, {length, height}, openings, 0, Facing::Along);
  cut_sheet(front, {length, height}, openings, -thickness, Facing::Against);
  sides(modeller_, front, rectangle({0, 0}, {length, height}), -thickness, 0);
  for (const Opening& opening : openings) {
    const Outline reveal = reversed(rectangle(opening.low, opening.high));
    for (std::size_t i = 0; i < 4; ++i) {
      const bool at_floor = reveal[i].v == 0 && reveal[(i + 1) % 4].v == 0;
      if (!at_floor) modeller_.face(side(front, reveal[i], reveal[(i + 1) % 4], -thickness, 0));
    }
  }
}

}  // namespace rad::corpus
