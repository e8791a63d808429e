#include "cli/model_views.h"

#include <algorithm>
#include <memory>
#include <new>

#include "cli/judge.h"
#include "report/html/model_view.h"

namespace rad::cli {

namespace {

template <typename Command>
bool has_html(const Command& command) {
  return command.format->name == "html" ||
         std::ranges::any_of(command.reports, [](const auto& file) { return file.format->name == "html"; });
}

bool knows_all_faces(const scene::Scene& scene, const report::InputReport& input) {
  return std::ranges::all_of(input.result.findings, [&](const scene::Finding& finding) {
    return std::ranges::all_of(finding.where.face_ids, [&](scene::FaceId face) { return face < scene.faces.size(); });
  });
}

std::shared_ptr<const report::html::ModelView> view_of(const LintCommand& command, const ModelOptions& options,
                                                       const report::InputReport& input) {
  try {
    const Model model = read_model(input.path, options);
    if (!model.report.read || !knows_all_faces(model.content.scene, input)) return nullptr;
    auto view = report::html::model_view(model.content.scene, input, command.max_issues);
    return view ? std::make_shared<const report::html::ModelView>(std::move(*view)) : nullptr;
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace

void add_views(const LintCommand& command, RunSettings& settings, report::Report& report) {
  for (report::InputReport& input : report.inputs) {
    if (input.read) input.view = view_of(command, settings.of(input.path)->model, input);
  }
}

bool asks_for_html(const LintCommand& command) { return has_html(command); }
bool asks_for_html(const DiffCommand& command) { return has_html(command); }

}  // namespace rad::cli
