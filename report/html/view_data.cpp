#include "report/html/view_data.h"

#include <fmt/format.h>

#include <cmath>

#include "report/html/escape.h"

namespace rad::report::html {
namespace {

// Seven decimals of a cube of size 2: a tenth of a step of the geometry.
constexpr double kDecimals = 1e7;

class Cube {
 public:
  explicit Cube(const PackedGeometry& geometry)
      : low_(geometry.low), half_(geometry.step > 0 ? geometry.step * kSteps / 2 : 1) {}

  [[nodiscard]] double half() const { return half_; }
  [[nodiscard]] geom::dvec3 middle() const { return low_ + half_; }
  void append(Json& json, const geom::dvec3& point) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double value = (point[axis] - low_[axis]) / half_ - 1;
      json.push_back(number(std::round(value * kDecimals) / kDecimals));
    }
  }
  [[nodiscard]] Json point(const geom::dvec3& point) const {
    Json json = Json::array();
    append(json, point);
    return json;
  }
  [[nodiscard]] Json camera(const bake::Camera& camera) const {
    return {{"position", point(camera.position)},
            {"target", point(camera.target)},
            {"fieldOfView", camera.vertical_field_of_view_deg}};
  }

 private:
  geom::dvec3 low_;
  double half_;
};

// A report that was read back knows the worst place only.
std::vector<scene::FaultPlace> places_of(const scene::Finding& finding) {
  if (!finding.where.places.empty()) return finding.where.places;
  return {{finding.where.point, finding.where.segment}};
}

Json fault_json(const Cube& cube, const FaultView& view, const scene::Finding& finding) {
  Json json;
  json["severity"] = scene::name(finding.severity);
  json["rule"] = finding.rule;
  json["camera"] = view.camera ? cube.camera(*view.camera) : Json(nullptr);
  Json points = Json::array(), lines = Json::array(), triangles = Json::array();
  for (const scene::FaultPlace& place : places_of(finding)) {
    if (place.point) cube.append(points, *place.point);
    if (!place.segment) continue;
    cube.append(lines, (*place.segment)[0]);
    cube.append(lines, (*place.segment)[1]);
  }
  for (const auto& [first, count] : view.triangles) {
    triangles.push_back(first);
    triangles.push_back(count);
  }
  json["points"] = std::move(points);
  json["lines"] = std::move(lines);
  json["triangles"] = std::move(triangles);
  return json;
}

}  // namespace

Json view_json(const ModelView& view, const std::vector<const scene::Finding*>& findings, const PackedGeometry& frame) {
  const Cube cube(frame), own(view.geometry);
  Json json;
  json["up"] = point_json(view.up);
  json["camera"] = cube.camera(view.camera);
  json["triangles"] = view.triangles;
  json["leftOut"] = view.left_out;
  json["place"] = {{"scale", number(own.half() / cube.half())}, {"offset", cube.point(own.middle())}};
  Json faults = Json::array();
  for (std::size_t i = 0; i < findings.size(); ++i) faults.push_back(fault_json(cube, view.faults[i], *findings[i]));
  json["faults"] = std::move(faults);
  return json;
}

std::string data_element(std::string_view name, const std::string& bytes, std::size_t model, std::string_view side) {
  return fmt::format("<script type=\"text/plain\" class=\"{}\" data-model=\"{}\" data-side=\"{}\">{}</script>\n", name,
                     model, side, base64(bytes));
}

std::string view_elements(const ModelView& view, const std::vector<const scene::Finding*>& findings,
                          const PackedGeometry& frame, std::size_t model, std::string_view side) {
  return data_element("view", compressed(script_json(view_json(view, findings, frame))), model, side) +
         data_element("geometry", view.geometry.bytes, model, side);
}

}  // namespace rad::report::html
