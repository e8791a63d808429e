#include "report/diff_report.h"
#include "report/finding_json.h"
#include "report/json_parts.h"

namespace rad::report {

namespace {

Json counts_json(const DiffCounts& counts) {
  Json json;
  for (const DiffStatus status : kDiffStatuses) json[std::string(name(status))] = counts[status];
  return json;
}

Json side_json(const InputReport* input) {
  if (input == nullptr) return nullptr;
  Json json;
  json["path"] = input->path;
  json["format"] = input->format.empty() ? Json(nullptr) : Json(input->format);
  json["tolerance"] = tolerance_json(*input);
  return json;
}

/// Findings of one side of a row, as they stand in its report.
Json findings_json(const std::vector<const scene::Finding*>& findings, const InputReport* input, const Report& report) {
  Json json = Json::array();
  if (input == nullptr) return json;
  const auto index = static_cast<std::size_t>(input - report.inputs.data());
  for (const scene::Finding* finding : findings) json.push_back(finding_json(*finding, index, input->metres_per_unit));
  return json;
}

Json row_json(const DiffRow& row, const DiffFile& file, const Diff& diff) {
  Json json;
  json["status"] = name(row.status);
  json["rule"] = row.shown().rule;
  json["severity"] = scene::name(row.shown().severity);
  json["change"] = row.change.empty() ? Json(nullptr) : Json(row.change);
  json["worse"] = row.worse;
  json["moved"] = number(row.moved);
  json["old"] = findings_json(row.old, file.old, *diff.old);
  json["new"] = findings_json(row.now, file.now, *diff.now);
  return json;
}

Json file_json(const DiffFile& file, const Diff& diff) {
  Json json;
  json["old"] = side_json(file.old);
  json["new"] = side_json(file.now);
  json["summary"] = counts_json(counts(file));
  json["rows"] = Json::array();
  for (const DiffRow& row : file.rows) json["rows"].push_back(row_json(row, file, diff));
  return json;
}

}  // namespace

std::string diff_json(const Diff& diff) {
  const Counts worse = regressions(diff);
  Json json;
  json["schemaVersion"] = kDiffSchemaVersion;
  json["tool"] = tool_json(diff.now->tool);
  json["stage"] = validate::name(diff.now->stage);
  json["failOn"] = name(diff.now->fail_on);
  json["verdict"] = fails(diff) ? "fail" : "pass";
  json["summary"] = counts_json(counts(diff));
  json["regressions"] = {{"errors", worse.errors}, {"warnings", worse.warnings}, {"notes", worse.notes}};
  json["gaps"] = gaps(diff);
  json["files"] = Json::array();
  for (const DiffFile& file : diff.files) json["files"].push_back(file_json(file, diff));
  return written(json);
}

}  // namespace rad::report
