#include "report/repair_report.h"

#include "report/changes_json.h"
#include "report/finding_json.h"
#include "report/json_parts.h"
#include "report/thin_list.h"

namespace rad::report {
namespace {

std::string_view name(RepairDone done) {
  switch (done) {
    case RepairDone::Skipped:
      return "skipped";
    case RepairDone::NotNeeded:
      return "not-needed";
    case RepairDone::Done:
      return "done";
    case RepairDone::Not:
      break;
  }
  return "not-done";
}

Json ledger_json(const scene::Ledger& ledger) {
  Json list = Json::array();
  for (const scene::LedgerEntry& entry : ledger) {
    Json json{{"stage", entry.stage},
              {"operation", entry.operation},
              {"rules", entry.rules},
              {"count", entry.count},
              {"largestMovement", number(entry.largest_movement)},
              {"areaChange", entry.area_change ? number(*entry.area_change) : Json(nullptr)}};
    for (const scene::LedgerPlace& place : entry.places) {
      json["places"].push_back(
          {{"point", point_json(place.point)}, {"area", number(place.area)}, {"face", face_json(place.face)}});
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json side_json(const scene::CoplanarRemoval::Side& side) {
  return {{"object", side.object}, {"material", side.material}, {"face", face_json(side.face)}};
}

Json removals_json(const scene::CoplanarRemovals& removals) {
  Json list = Json::array();
  for (const scene::CoplanarRemoval& removal : removals) {
    list.push_back({{"winner", side_json(removal.winner)},
                    {"loser", side_json(removal.loser)},
                    {"rule", std::string(1, removal.rule)},
                    {"tie", removal.tie},
                    {"count", removal.count},
                    {"area", number(removal.area)},
                    {"point", point_json(removal.point)}});
  }
  return list;
}

Json thin_features_json(const InputReport& input) {
  Json list = Json::array();
  for (const scene::Finding& finding : thin_features(input)) {
    list.push_back(finding_json(finding, 0, input.metres_per_unit));
  }
  return list;
}

Json areas_json(const std::vector<AreaFigure>& areas) {
  Json list = Json::array();
  for (const AreaFigure& figure : areas) list.push_back({{"stage", figure.stage}, {"area", number(figure.area)}});
  return list;
}

Json distance_json(const Changes& changes) {
  return {{"resultToInput", number(changes.result_to_input)}, {"inputToResult", number(changes.input_to_result)}};
}

Json mesh_json(const MeshFigures& figures) {
  return {{"faces", figures.faces},
          {"patches", figures.patches},
          {"elements", figures.elements},
          {"nodes", figures.nodes},
          {"patchSize", number(figures.patch_size)},
          {"elementSize", number(figures.element_size)},
          {"shape",
           {{"median", number(figures.shape_median)},
            {"firstPercentile", number(figures.shape_first_percentile)},
            {"histogram", figures.shape_histogram},
            {"blunt",
             {{"patches", figures.blunt.patches},
              {"median", number(figures.blunt.shape_median)},
              {"firstPercentile", number(figures.blunt.shape_first_percentile)}}}}},
          {"quads", figures.quads},
          {"density", {{"patches", number(figures.patches_per_area)}, {"elements", number(figures.elements_per_area)}}},
          {"deepestLevel", figures.deepest_level},
          {"bytesPerElement", number(figures.bytes_per_element)}};
}

Json light_map_json(const LightMapFigures& figures) {
  return {{"charts", figures.charts},
          {"texel", number(figures.texel)},
          {"texels", figures.texels},
          {"clampedShare", number(figures.clamped_share)},
          {"files", figures.files}};
}

Json solution_json(const SolutionFigures& figures) {
  const mesh::EnergyLedger& energy = figures.energy;
  return {{"shots", figures.shots},
          {"complete", figures.complete},
          {"unshotShare", number(energy.unshot_share())},
          {"elementsAdded", figures.elements_added},
          {"exposure", figures.exposure ? number(*figures.exposure) : Json(nullptr)},
          {"lightMap", figures.light_map ? light_map_json(*figures.light_map) : Json(nullptr)},
          {"energy",
           {{"emitted", point_json(energy.emitted)},
            {"shot", point_json(energy.shot)},
            {"received", point_json(energy.received)},
            {"reflected", point_json(energy.reflected)},
            {"absorbed", point_json(energy.absorbed)},
            {"escaped", point_json(energy.escaped)},
            {"unshot", point_json(energy.unshot)}}}};
}

Json stages_json(const scene::StageTimings& timings) {
  Json seconds = Json::object();
  for (const auto& [stage, taken] : timings) seconds[stage] = taken;
  return seconds;
}

}  // namespace

std::string json(const RepairReport& report) {
  Json json;
  json["schemaVersion"] = kRepairSchemaVersion;
  json["tool"] = tool_json("radfix");
  json["inputs"] = inputs_json(report.before);
  json["outputs"] = report.after ? inputs_json(*report.after) : Json::array();
  json["tolerance"] = only_tolerance_json(report.before);
  json["before"] = summary_json(report.before);
  json["thinFeatures"] = thin_features_json(report.before.inputs.front());
  json["after"] = report.after ? summary_json(*report.after) : Json(nullptr);
  json["dryRun"] = report.dry_run;
  json["stages"] = {{"asked", report.stages_asked}, {"done", report.stages_done}};
  json["repair"] = name(report.repair);
  json["ledger"] = ledger_json(report.ledger);
  json["coplanar"] = removals_json(report.removals);
  json["areas"] = areas_json(report.areas);
  json["distance"] = report.changes ? distance_json(*report.changes) : Json(nullptr);
  json["merged"] = report.changes ? merged_json(report.changes->merged) : Json::array();
  json["changes"] = report.changes ? changes_json(*report.changes) : Json::array();
  json["provenance"] = report.provenance ? provenance_json(*report.provenance) : Json(nullptr);
  json["contracts"] = report.contracts ? contracts_json(*report.contracts) : Json(nullptr);
  json["mesh"] = report.mesh ? mesh_json(*report.mesh) : Json(nullptr);
  json["solution"] = report.solution ? solution_json(*report.solution) : Json(nullptr);
  json["incomplete"] = report.incomplete;
  json["timings"] = stages_json(report.timings);
  return written(json);
}

}  // namespace rad::report
