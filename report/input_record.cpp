#include "report/input_record.h"

#include <algorithm>

#include "scene/byte_archive.h"
#include "validate/message.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

constexpr std::string_view kHead = "rad3";  // goes up with every change of what follows

}  // namespace

// The overloads below are looked up by these, so they are in no namespace without a name.
class RecordWriter : public scene::ByteWriter {};
class RecordReader : public scene::ByteReader {
 public:
  using ByteReader::ByteReader;
};

// A rule by its place among all: readers are of the same build as writers, and the cache sees to it.
template <typename Archive>
static void exchange_rule(Archive& archive, const validate::Rule*& rule) {
  const auto rules = validate::all_rules();
  std::uint64_t index = 0;
  if (Archive::kWrites) index = static_cast<std::uint64_t>(std::ranges::find(rules, rule) - rules.begin());
  exchange(archive, index);
  if (index >= rules.size()) throw scene::BadBytes();
  rule = rules[index];
}

template <typename Archive>
static void exchange(Archive& archive, scene::FaultPlace& place) {
  exchange_all(archive, place.point, place.segment);
}

template <typename Archive>
static void exchange(Archive& archive, scene::FaceReference& face) {
  exchange_all(archive, face.ref, face.line, face.pointer, face.entity);
}

template <typename Archive>
static void exchange(Archive& archive, scene::Where& where) {
  exchange_all(archive, where.point, where.segment, where.bounds, where.frame, where.file, where.line,
               where.byte_offset, where.pointer, where.objects, where.materials, where.face_count);
}

template <typename Archive>
static void exchange_detail(Archive& archive, Detail detail, scene::Where& where) {
  if (detail == Detail::Faces) exchange(archive, where.faces);
  if (detail == Detail::Drawings) exchange_all(archive, where.face_ids, where.places);
}

template <typename Archive>
static void exchange_measure(Archive& archive, const validate::Rule& rule, std::optional<scene::Measure>& measure) {
  bool there = measure.has_value();
  exchange(archive, there);
  if (!there) return;
  double value = Archive::kWrites ? measure->value : 0;
  std::optional<double> threshold = Archive::kWrites ? measure->threshold : std::nullopt;
  exchange_all(archive, value, threshold);
  if (!Archive::kWrites) measure = validate::measure_of(rule, value, threshold);
}

template <typename Archive>
static void exchange(Archive& archive, scene::Finding& finding) {
  const validate::Rule* rule = Archive::kWrites ? validate::find_rule(finding.rule) : nullptr;
  exchange_rule(archive, rule);
  if (!Archive::kWrites) finding = validate::finding_frame(*rule, rule->severity);
  exchange_all(archive, finding.severity, finding.kind, finding.message, finding.area, finding.kept_below,
               finding.where, finding.count, finding.fingerprint, finding.baseline);
  exchange_measure(archive, *rule, finding.measure);
}

template <typename Archive>
static void exchange(Archive& archive, scene::IssuePlace& place) {
  exchange_all(archive, place.file, place.line, place.byte_offset, place.pointer);
}

template <typename Archive>
static void exchange(Archive& archive, validate::SuppressionUse& use) {
  exchange_all(archive, use.origin, use.rules, use.reason, use.place, use.findings, use.places);
}

template <typename Archive>
static void exchange(Archive& archive, validate::SuppressedFinding& suppressed) {
  exchange_all(archive, suppressed.finding, suppressed.by);
}

template <typename Archive>
static void exchange(Archive& archive, geom::AutoChoice& choice) {
  exchange_all(archive, choice.confidence, choice.low, choice.high, choice.usual, choice.joined);
}

template <typename Archive>
static void exchange(Archive& archive, geom::Tolerance& tolerance) {
  exchange_all(archive, tolerance.length, tolerance.pitches, tolerance.diagonal, tolerance.source, tolerance.choice);
}

template <typename Archive>
static void exchange(Archive& archive, validate::ModelFigures& figures) {
  exchange_all(archive, figures.vertices, figures.faces, figures.triangles, figures.objects, figures.materials,
               figures.emitters);
}

template <typename Archive>
static void exchange(Archive& archive, std::pair<std::string, double>& lap) {
  exchange_all(archive, lap.first, lap.second);
}

template <typename Archive>
static void exchange_checked(Archive& archive, std::vector<const validate::Rule*>& checked) {
  if constexpr (Archive::kWrites) {
    archive.number(checked.size());
  } else {
    checked.resize(archive.count());
  }
  for (const validate::Rule*& rule : checked) exchange_rule(archive, rule);
}

template <typename Archive>
static void exchange(Archive& archive, validate::LintResult& result) {
  exchange_all(archive, result.findings, result.tolerance, result.pitch, result.lattice_origin, result.figures,
               result.suppressions, result.suppressed, result.incomplete, result.refusal, result.timings);
  exchange_checked(archive, result.checked);
}

template <typename Archive>
static void exchange(Archive& archive, InputReport& input) {
  exchange_all(archive, input.path, input.configuration, input.format, input.bytes, input.metres_per_unit,
               input.units_source, input.up, input.up_source, input.box.low, input.box.high, input.read, input.result);
}

// After all else, so that a reader may stop before it.
template <typename Archive>
static void exchange_details(Archive& archive, Detail last, validate::LintResult& result) {
  for (const Detail detail : {Detail::Faces, Detail::Drawings}) {
    if (detail > last) return;
    for (scene::Finding& finding : result.findings) exchange_detail(archive, detail, finding.where);
    for (validate::SuppressedFinding& suppressed : result.suppressed) {
      exchange_detail(archive, detail, suppressed.finding.where);
    }
  }
}

namespace {

bool names_its_suppressions(const validate::LintResult& result) {
  return std::ranges::all_of(result.suppressed, [&](const validate::SuppressedFinding& suppressed) {
    return suppressed.by < result.suppressions.size();
  });
}

}  // namespace

std::string record_of(InputReport input) {
  RecordWriter writer;
  exchange(writer, input);
  exchange_details(writer, Detail::Drawings, input.result);
  return std::string(kHead) + writer.take();
}

std::optional<InputReport> input_of_record(std::string_view bytes, Detail detail) {
  if (!bytes.starts_with(kHead)) return std::nullopt;
  try {
    RecordReader reader(bytes.substr(kHead.size()));
    std::optional<InputReport> input(std::in_place);
    exchange(reader, *input);
    exchange_details(reader, detail, input->result);
    if (detail == Detail::Drawings && !reader.at_end()) return std::nullopt;
    if (!names_its_suppressions(input->result)) return std::nullopt;
    return input;
  } catch (const scene::BadBytes&) {
    return std::nullopt;
  }
}

}  // namespace rad::report
