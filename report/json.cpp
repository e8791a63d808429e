#include "report/json.h"

#include <map>
#include <string_view>

#include "report/finding_json.h"
#include "report/json_parts.h"
#include "report/listed_findings.h"

namespace rad::report {

namespace {

Json findings_json(const Report& report) {
  Json json = Json::array();
  for (std::size_t index = 0; index < report.inputs.size(); ++index) {
    const InputReport& input = report.inputs[index];
    for (const scene::Finding* finding : listed_findings(input, report.max_issues)) {
      json.push_back(finding_json(*finding, index, input.metres_per_unit));
    }
  }
  return json;
}

Json suppressed_json(const Report& report) {
  Json json = Json::array();
  for (std::size_t index = 0; index < report.inputs.size(); ++index) {
    const InputReport& input = report.inputs[index];
    std::map<std::string_view, std::size_t> listed;
    for (const auto& [finding, by] : input.result.suppressed) {
      if (report.max_issues > 0 && ++listed[finding.rule] > report.max_issues) continue;
      json.push_back({{"by", by}, {"finding", finding_json(finding, index, input.metres_per_unit)}});
    }
  }
  return json;
}

Json shard_json(const Shard& shard) {
  Json json;
  json["index"] = shard.index;
  json["count"] = shard.count;
  json["files"] = shard.files;
  json["positions"] = shard.positions;
  return json;
}

Json invocation_json(const Report& report) {
  Json json;
  json["stage"] = validate::name(report.stage);
  json["failOn"] = name(report.fail_on);
  json["select"] = report.select;
  json["ignore"] = report.ignore;
  if (report.shard) json["shard"] = shard_json(*report.shard);
  return json;
}

// What holds for a run as a whole.
Report without_inputs(const Report& report) {
  Report head;
  head.tool = report.tool;
  head.stage = report.stage;
  head.fail_on = report.fail_on;
  head.select = report.select;
  head.ignore = report.ignore;
  head.max_issues = report.max_issues;
  return head;
}

}  // namespace

Json report_json(const Report& report, bool with_timings) {
  Json json;
  json["schemaVersion"] = kSchemaVersion;
  json["tool"] = tool_json(report.tool);
  json["invocation"] = invocation_json(report);
  json["inputs"] = inputs_json(report);
  json["tolerance"] = only_tolerance_json(report);
  json["verdict"] = counts(report).errors == 0 ? "pass" : "fail";
  json["summary"] = summary_json(report);
  json["findings"] = findings_json(report);
  json["suppressed"] = suppressed_json(report);
  json["timings"] = timings_json(report, with_timings);
  return json;
}

std::string json(const Report& report, bool with_timings) { return written(report_json(report, with_timings)); }

std::string json_lines(const Report& report, bool with_timings) {
  std::string out;
  Report alone = without_inputs(report);
  for (const InputReport& input : report.inputs) {
    alone.inputs = {input};
    out += written_on_one_line(report_json(alone, with_timings));
  }
  return out;
}

}  // namespace rad::report
