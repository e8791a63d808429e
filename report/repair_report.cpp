#include "report/repair_report.h"

#include "report/json_parts.h"

namespace rad::report {

std::string json(const RepairReport& report) {
  Json json;
  json["schemaVersion"] = kSchemaVersion;
  json["tool"] = tool_json("radfix");
  json["inputs"] = inputs_json(report.before);
  json["outputs"] = report.after ? inputs_json(*report.after) : Json::array();
  json["tolerance"] = only_tolerance_json(report.before);
  json["before"] = summary_json(report.before);
  json["after"] = report.after ? summary_json(*report.after) : Json(nullptr);
  json["ledger"] = Json::array();
  json["timings"] = Json::object();
  return written(json);
}

}  // namespace rad::report
