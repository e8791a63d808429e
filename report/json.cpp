#include "report/json.h"

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

Json invocation_json(const Report& report) {
  Json json;
  json["stage"] = validate::name(report.stage);
  json["failOn"] = name(report.fail_on);
  json["select"] = report.select;
  json["ignore"] = report.ignore;
  return json;
}

}  // namespace

std::string json(const Report& report, bool with_timings) {
  Json json;
  json["schemaVersion"] = kSchemaVersion;
  json["tool"] = tool_json(report.tool);
  json["invocation"] = invocation_json(report);
  json["inputs"] = inputs_json(report);
  json["tolerance"] = only_tolerance_json(report);
  json["verdict"] = counts(report).errors == 0 ? "pass" : "fail";
  json["summary"] = summary_json(report);
  json["findings"] = findings_json(report);
  json["timings"] = timings_json(report, with_timings);
  return written(json);
}

}  // namespace rad::report
