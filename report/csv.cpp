#include "report/csv.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "report/printable.h"

namespace rad::report {

namespace {

constexpr std::string_view kHeader =
    "file,line,pointer,rule,alias,requirement,severity,kind,places,message,measure,value,threshold,unit,x,y,z,objects,"
    "materials,faces,first_face,fix,operation,fingerprint\n";

std::string cell(std::string_view text) {
  std::string clean = printable(text);
  if (!clean.empty() && std::string_view("=+-@").find(clean.front()) != std::string_view::npos)
    clean.insert(0, 1, '\'');
  if (clean.find_first_of("\",") == std::string::npos) return clean;
  std::string quoted = "\"";
  for (const char c : clean) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

// Shortest form that reads back as the same number; empty for none.
std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value == 0 ? 0.0 : value) : ""; }

std::string cell(std::span<const std::string> names) {
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : "; ") + name;
  return cell(joined);
}

std::string measure_cells(const std::optional<scene::Measure>& measure) {
  if (!measure) return ",,,";
  return fmt::format("{},{},{},{}", cell(measure->name), cell(measure->value),
                     measure->threshold ? cell(*measure->threshold) : "", cell(measure->unit));
}

std::string point_cells(const std::optional<geom::dvec3>& point) {
  return point ? fmt::format("{},{},{}", cell(point->x), cell(point->y), cell(point->z)) : ",,";
}

std::string row(const scene::Finding& finding) {
  const scene::Where& where = finding.where;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", cell(where.file),
                     where.line > 0 ? std::to_string(where.line) : "", cell(where.pointer), finding.rule, finding.alias,
                     finding.requirement, scene::name(finding.severity), scene::name(finding.kind), finding.count,
                     cell(finding.message), measure_cells(finding.measure), point_cells(where.point),
                     cell(where.objects), cell(where.materials), where.face_count,
                     where.faces.empty() ? "" : cell(where.faces.front().ref), scene::name(finding.fix.applicability),
                     cell(finding.fix.operation), finding.fingerprint);
}

}  // namespace

std::string csv(const Report& report) {
  std::string out(kHeader);
  for (const InputReport& input : report.inputs) {
    for (const scene::Finding& finding : input.result.findings) out += row(finding);
  }
  return out;
}

}  // namespace rad::report
