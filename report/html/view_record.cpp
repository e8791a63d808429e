#include "report/html/view_record.h"

#include "report/json_parts.h"

namespace rad::report::html {
namespace {

// Numbers as they are, to the last bit.
Json exact(const geom::dvec3& point) { return Json::array({point.x, point.y, point.z}); }

geom::dvec3 point_of(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

Json bytes_json(const std::string& bytes) {
  return Json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

std::string bytes_of(const Json& json) {
  const auto& bytes = json.get_binary();
  return {bytes.begin(), bytes.end()};
}

Json camera_json(const bake::Camera& camera) {
  return Json::array(
      {exact(camera.position), exact(camera.target), exact(camera.up), camera.vertical_field_of_view_deg});
}

bake::Camera camera_of(const Json& json) {
  return {point_of(json.at(0)), point_of(json.at(1)), point_of(json.at(2)), json.at(3).get<double>()};
}

Json picture_json(const Picture& picture) {
  return Json::array({bytes_json(picture.png), picture.width, picture.height});
}

Picture picture_of(const Json& json) {
  return {bytes_of(json.at(0)), json.at(1).get<std::uint32_t>(), json.at(2).get<std::uint32_t>()};
}

Json fault_json(const FaultView& fault) {
  Json triangles = Json::array();
  for (const auto& [first, count] : fault.triangles) triangles.push_back(Json::array({first, count}));
  return Json::array(
      {fault.camera ? camera_json(*fault.camera) : Json(nullptr), triangles, picture_json(fault.picture)});
}

FaultView fault_of(const Json& json) {
  FaultView fault;
  if (!json.at(0).is_null()) fault.camera = camera_of(json.at(0));
  for (const Json& stretch : json.at(1)) {
    fault.triangles.emplace_back(stretch.at(0).get<std::size_t>(), stretch.at(1).get<std::size_t>());
  }
  fault.picture = picture_of(json.at(2));
  return fault;
}

}  // namespace

std::string view_record(const ModelView& view) {
  Json json;
  json["up"] = exact(view.up);
  json["camera"] = camera_json(view.camera);
  json["low"] = exact(view.geometry.low);
  json["step"] = view.geometry.step;
  json["geometry"] = bytes_json(view.geometry.bytes);
  json["triangles"] = view.triangles;
  json["leftOut"] = view.left_out;
  json["overview"] = picture_json(view.overview);
  Json faults = Json::array();
  for (const FaultView& fault : view.faults) faults.push_back(fault_json(fault));
  json["faults"] = std::move(faults);
  const std::vector<std::uint8_t> bytes = Json::to_cbor(json);
  return {bytes.begin(), bytes.end()};
}

std::optional<ModelView> view_of_record(std::string_view bytes) {
  try {
    const Json json = Json::from_cbor(bytes.begin(), bytes.end());
    ModelView view;
    view.up = point_of(json.at("up"));
    view.camera = camera_of(json.at("camera"));
    view.geometry = {point_of(json.at("low")), json.at("step").get<double>(), bytes_of(json.at("geometry"))};
    view.triangles = json.at("triangles").get<std::size_t>();
    view.left_out = json.at("leftOut").get<std::size_t>();
    view.overview = picture_of(json.at("overview"));
    for (const Json& fault : json.at("faults")) view.faults.push_back(fault_of(fault));
    return view;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace rad::report::html
