#include "cli/fix_report.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "cli/report_choice.h"
#include "report/repair_text.h"
#include "report/run_text.h"
#include "scene/scene_sources.h"

namespace rad::cli {
namespace {

using repair::FaceHistory;
using repair::History;
using scene::FaceId;

report::Report report_on(const Model& model) {
  report::Report report;
  report.tool = "radfix";
  report.inputs.push_back(model.report);
  return report;
}

scene::dvec3 middle_of(const scene::Scene& scene, FaceId face) {
  scene::dvec3 sum{0, 0, 0};
  const auto corners = scene.corners_of(scene.loops[scene.faces[face].first_loop]);
  for (const scene::VertexId corner : corners) sum += scene.vertices[corner];
  return corners.empty() ? sum : sum / static_cast<double>(corners.size());
}

// Faces of the input that were turned and nothing else: a face starts with the corner it started with.
History turns_of(const scene::Scene& input, const scene::Scene& turned) {
  History history;
  history.faces.resize(input.faces.size());
  for (FaceId face = 0; face < input.faces.size(); ++face) {
    history.faces[face].sources = {face};
    const auto loops = input.loops_of(input.faces[face]);
    history.faces[face].turned = std::ranges::any_of(loops, [&](const scene::Loop& loop) {
      return !std::ranges::equal(input.corners_of(loop), turned.corners_of(loop));
    });
  }
  return history;
}

class ChangeList {
 public:
  ChangeList(const scene::Scene& input, const History& history) : input_(input), history_(history) {}

  std::vector<report::Change> run() {
    add_moved();
    add_cut();
    add_faces("divided", [](const FaceHistory& face) { return face.divided; });
    add_faces("merged", [](const FaceHistory& face) { return face.merged(); });
    add_faces("turned", [](const FaceHistory& face) { return face.turned; });
    add_faces("won", [](const FaceHistory& face) { return face.won; });
    add("removed", history_.gone);
    return std::move(changes_);
  }

 private:
  [[nodiscard]] report::ChangePlace place(FaceId face) const {
    return {scene::reference_to(input_, face), middle_of(input_, face), 0};
  }

  void keep(report::Change change) {
    if (change.count > 0) changes_.push_back(std::move(change));
  }

  void add(const char* kind, const std::vector<FaceId>& faces) {
    report::Change change{kind, faces.size(), {}};
    for (std::size_t i = 0; i < std::min(faces.size(), report::kListedPlaces); ++i) {
      change.places.push_back(place(faces[i]));
    }
    keep(std::move(change));
  }

  template <typename Is>
  void add_faces(const char* kind, Is&& is) {
    std::vector<FaceId> sources;
    for (const FaceHistory& face : history_.faces) {
      if (is(face)) sources.push_back(face.sources.front());
    }
    add(kind, sources);
  }

  void add_cut() {
    std::vector<FaceId> cut;
    std::vector<std::uint32_t> parts(input_.faces.size(), 0);
    for (const FaceHistory& face : history_.faces) {
      for (const FaceId source : face.sources) ++parts[source];
    }
    for (FaceId face = 0; face < parts.size(); ++face) {
      if (parts[face] > 1) cut.push_back(face);
    }
    add("cut", cut);
  }

  void add_moved() {
    std::vector<const FaceHistory*> moved;
    for (const FaceHistory& face : history_.faces) {
      if (face.moved > 0) moved.push_back(&face);
    }
    std::ranges::stable_sort(moved, [](const auto* a, const auto* b) { return a->moved > b->moved; });
    report::Change change{"moved", moved.size(), {}};
    for (std::size_t i = 0; i < std::min(moved.size(), report::kListedPlaces); ++i) {
      change.places.push_back(
          {scene::reference_to(input_, moved[i]->sources.front()), moved[i]->moved_at, moved[i]->moved});
    }
    keep(std::move(change));
  }

  const scene::Scene& input_;
  const History& history_;
  std::vector<report::Change> changes_;
};

// Of the section that the first of a face's places is in; a face merged across sections names that one.
void add_input_places(const scene::Scene& input, report::Provenance& provenance) {
  report::RunText text;
  std::optional<std::uint32_t> section;
  const auto close = [&] {
    if (section) provenance.places.push_back({*section, text.take()});
  };
  for (FaceId face = 0; face < input.faces.size(); ++face) {
    const std::vector<scene::SourceRef> sources = scene::sources_of(input, face);
    if (section != sources.front().section) {
      close();
      section = sources.front().section;
    }
    std::vector<std::uint64_t> records;
    for (const scene::SourceRef& source : sources) {
      if (source.section == *section) records.push_back(source.record);
    }
    text.add(records);
  }
  close();
}

std::vector<std::string> names_of(const scene::FilterSet& filters) {
  std::vector<std::string> names;
  for (const scene::Filter filter : scene::kFilters) {
    if (filters.has(filter)) names.emplace_back(scene::name(filter));
  }
  return names;
}

void note_changes(const Model& before, const Product& product, report::RepairReport& report) {
  const auto history = history_of(before, product);
  if (history) report.changes = changes_of(before, *history);
  report.provenance = provenance_of(before, product);
}

}  // namespace

std::optional<History> history_of(const Model& before, const Product& product) {
  const repair::Repaired& repaired = product.work.repaired;
  if (product.repair != report::RepairDone::Done || repaired.model.faces.empty()) return std::nullopt;
  if (repaired.turned) return turns_of(before.content.scene, *repaired.turned);
  return repair::history_of(before.content.scene, repaired.model);
}

report::Changes changes_of(const Model& before, const History& history) {
  report::Changes changes;
  changes.kinds = ChangeList(before.content.scene, history).run();
  for (const repair::FarRegion& region : history.far) {
    changes.merged.push_back({region.at, region.distance, region.places});
  }
  changes.result_to_input = history.result_to_input;
  changes.input_to_result = history.input_to_result;
  return changes;
}

std::optional<report::Provenance> provenance_of(const Model& before, const Product& product) {
  const scene::PiecesOfModel& pieces = product.work.pieces;
  const scene::ConformingModel& model = product.work.repaired.model;
  if (product.scene.stage || !product.problem.empty()) return std::nullopt;
  report::Provenance provenance;
  report::RunText text;
  for (FaceId face = 0; face < product.scene.faces.size(); ++face) {
    std::vector<std::uint64_t> sources;
    if (product.work.input_as_it_was) {
      sources = {face};
    } else if (pieces.triangle[face] != scene::PiecesOfModel::kWhole) {
      sources = {model.origins[pieces.triangle[face]].source};
    } else {
      const auto faces = scene::source_faces(model, model.faces[pieces.face[face]]);
      sources.assign(faces.begin(), faces.end());
    }
    text.add(sources);
  }
  provenance.output_faces = product.scene.faces.size();
  provenance.sources = text.take();
  provenance.input_faces = before.content.scene.faces.size();
  provenance.sections = before.content.scene.sections;
  add_input_places(before.content.scene, provenance);
  return provenance;
}

report::RepairReport report_of(const Model& before, const Product& product, const FixCommand& command) {
  report::RepairReport report;
  report.before = report_on(before);
  report.dry_run = command.dry_run;
  report.stages_asked = names_of(command.filters);
  report.repair = product.repair;
  report.ledger = product.work.repaired.ledger;
  report.removals = product.work.repaired.removals;
  report.ledger.insert(report.ledger.begin(), product.left_out.begin(), product.left_out.end());
  for (const repair::StageArea& area : product.work.repaired.areas) report.areas.push_back({area.stage, area.area});
  report.mesh = product.mesh;
  report.solution = product.solution;
  report.incomplete = product.incomplete;
  if (command.timings) report.timings = product.timings;
  scene::FilterSet done = command.filters;
  done.remove(scene::kRepairFilters);
  for (const scene::Filter filter : scene::kFilters) {
    if (product.work.done.has(filter)) done.add(filter);
  }
  if (product.problem.empty()) report.stages_done = names_of(done);
  if (!command.reports.empty() || command.diff) note_changes(before, product, report);
  return report;
}

std::string written_report(const report::RepairReport& report, const FileReport& file, const FixCommand& command) {
  if (file.format->name == "json") return report::json(report);
  if (file.format->name == "text" && report.after) {
    report::RepairTextOptions options;
    options.picture = command.preview;
    options.viewer = command.viewer;
    options.annotated = command.annotate;
    options.diff = command.diff;
    return report::text(report, options);
  }
  report::WriteOptions options = file_write_options();
  options.timings = command.timings;
  return file.format->write(report.after ? *report.after : report.before, options);
}

}  // namespace rad::cli
