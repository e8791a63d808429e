#include "report/html/finding_item.h"

#include <fmt/format.h>

#include "report/html/escape.h"
#include "report/html/markup.h"
#include "report/text_layout.h"
#include "report/units.h"

namespace rad::report::html {
namespace {

using scene::Finding;

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string place_text(const scene::Where& where) {
  if (where.line > 0) return fmt::format("{}:{}", where.file, where.line);
  if (!where.pointer.empty()) return fmt::format("{}#{}", where.file, where.pointer);
  if (where.byte_offset) return fmt::format("{} byte {}", where.file, *where.byte_offset);
  return where.file;
}

std::string point_text(const geom::dvec3& point) {
  return fmt::format("({}, {}, {})", short_number(point.x), short_number(point.y), short_number(point.z));
}

std::string position_text(const Finding& finding, std::optional<double> metres_per_unit) {
  if (!finding.where.point) return {};
  const geom::dvec3& point = *finding.where.point;
  std::string text = fmt::format("{} {}", point_text(point), unit_label(metres_per_unit));
  if (metres_per_unit && *metres_per_unit != 1) text += fmt::format(" = {} m", point_text(point * *metres_per_unit));
  return text;
}

std::string measure_text(const Finding& finding) {
  if (!finding.measure) return {};
  const scene::Measure& measure = *finding.measure;
  const bool plain = measure.unit == "1" || measure.unit == "count" || measure.unit.empty();
  const std::string unit = plain ? "" : " " + std::string(measure.unit);
  std::string text = fmt::format("{} {}{}", measure.name, short_number(measure.value), unit);
  if (measure.threshold) text += fmt::format(", threshold {}{}", short_number(*measure.threshold), unit);
  return text;
}

std::string faces_text(const scene::Where& where) {
  std::string text;
  for (const scene::FaceReference& face : where.faces) text += (text.empty() ? "" : ", ") + face.ref;
  if (where.face_count > where.faces.size()) text += fmt::format(" and {} more", where.face_count - where.faces.size());
  return text;
}

void append_fact(std::string& out, std::string_view term, std::string_view fact) {
  if (!fact.empty()) out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", term, escaped(fact));
}

std::string facts(const Finding& finding, std::optional<double> metres_per_unit) {
  const scene::Where& where = finding.where;
  std::string out = "<dl class=\"facts\">";
  append_fact(out, "Where", place_text(where));
  append_fact(out, "Point", position_text(finding, metres_per_unit));
  append_fact(out, where.objects.size() == 1 ? "Object" : "Objects", joined(where.objects));
  append_fact(out, where.materials.size() == 1 ? "Material" : "Materials", joined(where.materials));
  append_fact(out, "Measure", measure_text(finding));
  if (finding.count > 1) append_fact(out, "Places", std::to_string(finding.count));
  out += "</dl>";
  if (where.faces.size() > 1 || where.face_count > 1) {
    out += fmt::format("<details class=\"faces\"><summary>{}</summary><p>{}</p></details>",
                       counted(where.face_count, "face"), escaped(faces_text(where)));
  }
  return out;
}

}  // namespace

std::string finding_item(const Finding& finding, std::optional<double> metres_per_unit, const ItemPlace& place) {
  std::string names;
  for (const std::string& object : finding.where.objects) names += escaped(object) + "&#10;";
  std::string out = fmt::format(
      R"(<li class="finding {0}" id="{1}" data-rule="{2}" data-severity="{0}" data-model="{3}" data-fault="{4}")"
      R"( data-objects="{5}" data-fingerprint="{6}"{7}><div class="text"><p class="message">{8}</p>)",
      scene::name(finding.severity), place.id, finding.rule, place.model, place.fault, names,
      escaped(finding.fingerprint), place.attributes, escaped(finding.message));
  if (!place.remark.empty()) out += fmt::format("<p class=\"change\">{}</p>", escaped(place.remark));
  out += facts(finding, metres_per_unit);
  const bool placed = place.view != nullptr && place.view->camera;
  if (placed) out += R"(<button type="button" class="fly" hidden>Show in 3-D</button>)";
  out += "</div>";
  if (place.view != nullptr) {
    out += image(place.view->picture, fmt::format("{} at {}", finding.alias, place_text(finding.where)), "thumb");
  }
  return out + "</li>\n";
}

}  // namespace rad::report::html
