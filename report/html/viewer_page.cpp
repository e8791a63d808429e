#include "report/html/viewer_page.h"

#include <fmt/format.h>

#include "bake/camera.h"
#include "bake/preview.h"
#include "report/html/assets.h"
#include "report/html/escape.h"
#include "report/html/view_data.h"
#include "report/report.h"

namespace rad::report::html {
namespace {

constexpr double kAspect = 1.6;

Json light_json(const scene::VertexLight& light, double largest, std::size_t elements) {
  Json palette = Json::array();
  for (const std::uint32_t code : scene::false_colours()) palette.push_back(code);
  return {{"exposure", light.exposure},
          {"curve", scene::name(light.curve)},
          {"largest", largest},
          {"palette", std::move(palette)},
          {"elements", elements}};
}

std::string head(const std::string& title) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src '{}'; style-src '{}'; "
      "img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"radfix {}\">\n<title>{} – radfix</title>\n<link rel=\"icon\" "
      "href=\"data:,\">\n"
      "<style>{}</style>\n</head>\n<body class=\"viewer\">\n",
      page_script().hash, page_style().hash, tool_version(), escaped(title), page_style().text);
}

}  // namespace

std::string viewer_page(const scene::Scene& scene, const scene::VertexLight& light, const std::string& title) {
  const std::vector<bake::DrawnTriangle> triangles = bake::drawn_triangles(scene);
  ModelView view;
  view.up = bake::up_direction(scene);
  view.camera = bake::light_camera(scene, light, kAspect);
  view.geometry = packed(scene, triangles);
  view.triangles = triangles.size();
  const PackedLight packed = packed_light(light, triangles);
  std::string out = head(title);
  out += fmt::format(
      "<header class=\"banner\"><p class=\"tool\">radfix {}</p><h1>{}</h1></header>\n<main>\n"
      "<noscript><p class=\"remark\">This page shows the model with a script, which this browser does not run.</p>"
      "</noscript>\n<div class=\"stage\" hidden></div>\n</main>\n",
      tool_version(), escaped(title));
  out += view_elements(view, {}, view.geometry, 0, "now") + data_element("light", packed.bytes, 0, "now");
  out += fmt::format("<script type=\"application/json\" id=\"light\">{}</script>\n<script>",
                     script_json(light_json(light, packed.largest, scene.faces.size())));
  out += page_script().text;
  return out + "</script>\n</body>\n</html>\n";
}

}  // namespace rad::report::html
