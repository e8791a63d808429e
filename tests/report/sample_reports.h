// Reports made by hand, for tests of what is written of them.
#pragma once

#include <string>

#include "report/report.h"
#include "validate/registry.h"

namespace rad::report::samples {

inline scene::Finding t_vertex(std::uint64_t line, double x) {
  scene::Finding finding;
  finding.rule = "RL201";
  finding.alias = "t-vertex";
  finding.requirement = "2a";
  finding.severity = scene::Severity::Error;
  finding.message = "3 T-vertices on an edge of \"floor\"";
  finding.measure = scene::Measure{"distance", 0.0, 0.0002, "file units"};
  finding.where.file = "room.obj";
  finding.where.line = line;
  finding.where.point = geom::dvec3{x, 0, 3.5};
  finding.where.segment = std::array{geom::dvec3{x - 1, 0, 3.5}, geom::dvec3{x + 1, 0, 3.5}};
  finding.where.bounds = std::array{geom::dvec3{x, 0, 3.5}, geom::dvec3{x, 0, 3.5}};
  finding.where.objects = {"floor"};
  finding.where.materials = {"wood"};
  finding.where.faces = {{"room.obj:" + std::to_string(line), line, ""}};
  finding.where.face_count = 2;
  finding.count = 3;
  finding.fingerprint = "0123456789abcdef";
  finding.fix = {scene::FixClass::Safe, "grouper"};
  return finding;
}

inline scene::Finding open_boundary() {
  scene::Finding finding = t_vertex(7, 0);
  finding.rule = "RL101";
  finding.alias = "open-boundary";
  finding.requirement = "1a";
  finding.severity = scene::Severity::Note;
  finding.kind = scene::FindingKind::Review;
  finding.message = "open surface";
  finding.measure.reset();
  finding.where.point.reset();
  finding.where.segment.reset();
  finding.where.bounds.reset();
  finding.count = 1;
  finding.fix = {scene::FixClass::Manual, ""};
  return finding;
}

/// A file that was read and has no findings.
inline InputReport clean_input(const std::string& path = "room.obj") {
  InputReport input;
  input.path = path;
  input.format = "obj";
  input.bytes = 5234;
  input.read = true;
  input.box.add({0, 0, 0});
  input.box.add({4, 5, 2.5});
  input.result.tolerance = geom::Tolerance{0.0002, 64, 6.8739, geom::ToleranceSource::Default};
  input.result.pitch = 0.000003125;
  input.result.figures = {.vertices = 96, .faces = 42, .triangles = 80, .objects = 4, .materials = 3, .emitters = 1};
  const auto rules = validate::all_rules();
  input.result.checked.assign(rules.begin(), rules.end());
  input.result.timings = {{"read", 0.25}, {"contacts", 0.5}};
  return input;
}

/// Two findings of RL201 in two clusters and a note.
inline InputReport broken_input(const std::string& path = "room.obj") {
  InputReport input = clean_input(path);
  input.result.findings = {t_vertex(120, 1.25), t_vertex(9, 10), open_boundary()};
  return input;
}

/// A file of which nothing could be read.
inline InputReport unreadable_input(const std::string& path = "torn.ply") {
  InputReport input;
  input.path = path;
  input.format = "ply";
  scene::Finding finding;
  finding.rule = "RL001";
  finding.alias = "parse-error";
  finding.requirement = "input";
  finding.message = "the header does not end";
  finding.where.file = path;
  finding.where.byte_offset = 17;
  finding.fingerprint = "fedcba9876543210";
  input.result.findings = {finding};
  return input;
}

/// Names that mean something to XML, Markdown, CSV, GitHub, terminals or nobody.
inline const std::string kHostileName =
    "=a\"b'c<d>&]]>|`*_[x](y)\n::error::\x1b[31m\xff\xe2\x80\xae@you,;%0A\r\\$(rm)<!--";

/// Every text that a file can choose is hostile.
inline InputReport hostile_input() {
  InputReport input = broken_input("dir/" + kHostileName + ".obj");
  for (scene::Finding& finding : input.result.findings) {
    finding.message = "T-vertex on \"" + kHostileName + "\"";
    finding.where.file = input.path;
    finding.where.pointer = "/nodes/" + kHostileName;
    finding.where.objects = {kHostileName};
    finding.where.materials = {kHostileName};
    for (scene::FaceReference& face : finding.where.faces) face.ref = kHostileName;
  }
  input.result.incomplete = kHostileName;
  return input;
}

inline Report report_on(std::vector<InputReport> inputs) {
  Report report;
  report.inputs = std::move(inputs);
  return report;
}

}  // namespace rad::report::samples
