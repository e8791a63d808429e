#include "report/read_parts.h"

#include <cmath>
#include <limits>

#include "validate/message.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

std::string text_of(const Json& json) { return json.is_null() ? std::string() : json.get<std::string>(); }

std::optional<std::array<geom::dvec3, 2>> read_pair(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return std::array{read_point(json.at(0)), read_point(json.at(1))};
}

std::uint64_t read_line(const Json& json) { return json.is_null() ? 0 : json.get<std::uint64_t>(); }

scene::FaceReference read_face(const Json& json) {
  const auto entity = json.find("entity");
  return {json.at("ref").get<std::string>(), read_line(json.at("line")), text_of(json.at("pointer")),
          entity == json.end() ? std::string() : text_of(*entity)};
}

scene::Where read_where(const Json& json) {
  scene::Where where;
  where.file = json.at("file").get<std::string>();
  where.line = read_line(json.at("line"));
  if (!json.at("point").is_null()) where.point = read_point(json.at("point"));
  where.segment = read_pair(json.at("segment"));
  where.bounds = read_pair(json.at("bounds"));
  if (!json.at("frame").is_null()) where.frame = read_point(json.at("frame"));
  where.objects = json.at("objects").get<std::vector<std::string>>();
  where.materials = json.at("materials").get<std::vector<std::string>>();
  where.pointer = text_of(json.at("pointer"));
  if (!json.at("byteOffset").is_null()) where.byte_offset = json.at("byteOffset").get<std::uint64_t>();
  for (const Json& face : json.at("faces")) where.faces.push_back(read_face(face));
  where.face_count = json.at("faceCount").get<std::uint64_t>();
  return where;
}

std::optional<scene::Measure> read_measure(const Json& json, const validate::Rule& rule) {
  if (json.is_null()) return std::nullopt;
  const Json& threshold = json.at("threshold");
  return validate::measure_of(rule, read_number(json.at("value")),
                              threshold.is_null() ? std::nullopt : std::optional(read_number(threshold)));
}

std::optional<double> read_optional(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() ? std::nullopt : std::optional(read_number(*found));
}

std::optional<geom::AutoChoice> read_choice(const Json& json) {
  const auto found = json.find("auto");
  if (found == json.end()) return std::nullopt;
  geom::AutoChoice choice;
  choice.confidence = read_number(json.at("confidence"));
  if (choice.confidence > 0) {
    choice.low = read_number(found->at("low"));
    choice.high = read_number(found->at("high"));
  }
  choice.usual = read_number(found->at("default"));
  choice.joined = found->at("joinedBeyondDefault").get<std::uint64_t>();
  return choice;
}

std::optional<geom::Tolerance> read_tolerance(const Json& json, double pitch) {
  if (json.is_null()) return std::nullopt;
  using geom::ToleranceSource;
  geom::Tolerance tolerance;
  tolerance.length = read_number(json.at("T"));
  tolerance.diagonal = read_number(json.at("diagonal"));
  tolerance.pitches = pitch > 0 ? std::llround(tolerance.length / pitch) : 1;
  tolerance.source =
      named(json.at("source"), ToleranceSource::Default, ToleranceSource::SinglePrecision, ToleranceSource::Lattice,
            ToleranceSource::Given, ToleranceSource::Recorded, ToleranceSource::Auto);
  tolerance.choice = read_choice(json);
  return tolerance;
}

void read_figures(const Json& json, InputReport& input) {
  validate::ModelFigures& figures = input.result.figures;
  figures.vertices = json.at("vertices").get<std::size_t>();
  figures.faces = json.at("faces").get<std::size_t>();
  figures.triangles = json.at("triangles").get<std::size_t>();
  figures.objects = json.at("objects").get<std::size_t>();
  figures.materials = json.at("materials").get<std::size_t>();
  figures.emitters = json.at("emitters").get<std::size_t>();
  if (const auto bounds = read_pair(json.at("bounds"))) {
    input.box.add((*bounds)[0]);
    input.box.add((*bounds)[1]);
  }
}

void read_frame(const Json& json, InputReport& input) {
  const Json& units = json.at("units");
  if (!units.at("metresPerUnit").is_null()) input.metres_per_unit = read_number(units.at("metresPerUnit"));
  input.units_source = named(units.at("source"), ValueSource::Unknown, ValueSource::Declared, ValueSource::Given);
  const Json& up = json.at("up");
  if (!up.at("value").is_null()) input.up = named(up.at("value"), scene::UpAxis::Y, scene::UpAxis::Z);
  input.up_source = named(up.at("source"), ValueSource::Unknown, ValueSource::Declared, ValueSource::Given);
}

validate::SuppressionUse read_suppression(const Json& json) {
  validate::SuppressionUse use;
  use.origin = named(json.at("origin"), scene::WaiverOrigin::Model, scene::WaiverOrigin::Sidecar,
                     scene::WaiverOrigin::Configuration);
  use.rules = json.at("rules").get<std::vector<std::string>>();
  use.reason = text_of(json.at("reason"));
  use.place.file = json.at("file").get<std::string>();
  use.place.line = read_line(json.at("line"));
  use.place.pointer = text_of(json.at("pointer"));
  use.findings = json.at("findings").get<std::uint64_t>();
  use.places = json.at("places").get<std::uint64_t>();
  return use;
}

// Reports before 1.2.0 have neither suppressions nor configuration.
void read_since_1_2(const Json& json, InputReport& input) {
  if (const auto path = json.find("configuration"); path != json.end()) input.configuration = text_of(*path);
  const auto suppressions = json.find("suppressions");
  if (suppressions == json.end()) return;
  for (const Json& use : *suppressions) input.result.suppressions.push_back(read_suppression(use));
}

}  // namespace

const validate::Rule& rule_of(const Json& json) {
  const auto& id = json.get_ref<const std::string&>();
  if (const validate::Rule* rule = validate::find_rule(id)) return *rule;
  throw UnknownShape("rule '" + id + "' is not known to this version");
}

double read_number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

geom::dvec3 read_point(const Json& json) {
  return {read_number(json.at(0)), read_number(json.at(1)), read_number(json.at(2))};
}

scene::Severity read_severity(const Json& json) {
  return named(json, scene::Severity::Note, scene::Severity::Warning, scene::Severity::Error);
}

InputReport read_input(const Json& json) {
  InputReport input;
  input.path = json.at("path").get<std::string>();
  input.format = text_of(json.at("format"));
  input.bytes = json.at("bytes").get<std::uint64_t>();
  input.read = json.at("read").get<bool>();
  read_frame(json, input);
  if (const Json& lattice = json.at("lattice"); !lattice.is_null()) {
    input.result.pitch = read_number(lattice.at("pitch"));
    input.result.lattice_origin = read_point(lattice.at("origin"));
  }
  input.result.tolerance = read_tolerance(json.at("tolerance"), input.result.pitch);
  input.result.incomplete = text_of(json.at("incomplete"));
  read_figures(json.at("figures"), input);
  read_since_1_2(json, input);
  return input;
}

scene::Finding read_finding(const Json& json) {
  const validate::Rule& rule = rule_of(json.at("rule"));
  scene::Finding finding = validate::finding_frame(rule, read_severity(json.at("severity")));
  finding.kind =
      named(json.at("kind"), scene::FindingKind::Fail, scene::FindingKind::Review, scene::FindingKind::Informational);
  finding.message = json.at("message").get<std::string>();
  finding.measure = read_measure(json.at("measure"), rule);
  finding.area = read_optional(json, "area");
  finding.kept_below = read_optional(json, "keptBelow");
  finding.where = read_where(json.at("where"));
  finding.count = json.at("count").get<std::uint64_t>();
  finding.fingerprint = json.at("fingerprint").get<std::string>();
  if (const auto state = json.find("baseline"); state != json.end()) {
    finding.baseline = named(*state, scene::BaselineState::New, scene::BaselineState::Grown);
  }
  return finding;
}

}  // namespace rad::report
