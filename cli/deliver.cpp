#include "cli/deliver.h"

#include <filesystem>

#include "bake/legend.h"
#include "bake/png.h"
#include "bake/preview.h"
#include "report/html/viewer_page.h"
#include "validate/promises.h"
#include "validate/registry.h"
#include "writers/registry.h"
#include "writers/stage.h"
#include "writers/whole_file.h"

namespace rad::cli {
namespace {

// Of a picture whose place is given, degrees: about what a person looks at without turning.
constexpr double kEyeField = 50;

writers::Output output_of(const Product& product) {
  writers::Output output{product.scene};
  output.light = product.light ? &*product.light : nullptr;
  output.light_map = product.light_map ? &product.light_map->map : nullptr;
  output.lattice = product.lattice;
  output.marked_incomplete = product.incomplete;
  return output;
}

// The input stays as IN.orig, and the material file that would be written beside it likewise.
std::string keep_original(const std::string& input) {
  namespace fs = std::filesystem;
  std::error_code error;
  for (const fs::path& path : {fs::path(input), fs::path(input).replace_extension(".mtl")}) {
    if (!fs::exists(path, error)) continue;
    fs::copy_file(path, path.string() + ".orig", error);
    if (error) return path.string() + ".orig: cannot be written: " + error.message();
  }
  return {};
}

// Before the model, which refers to its pages.
std::string write_light_map(const Product& product) {
  if (!product.light_map) return {};
  std::vector<writers::WholeFile> files;
  for (const FileBeside& file : product.light_map->files) files.push_back({file.path, *file.bytes});
  return writers::write_whole_files(files);
}

std::string write_preview(const Product& product, const FixCommand& command) {
  if (command.preview.empty()) return {};
  bake::PreviewOptions options;
  options.outline_faces = command.drawn_mesh != DrawnMesh::None;
  if (command.camera) {
    options.camera = bake::Camera{.position = command.camera->from,
                                  .target = command.camera->to,
                                  .up = bake::up_direction(product.scene),
                                  .vertical_field_of_view_deg = kEyeField};
  }
  bake::Image picture = product.patches
                            ? bake::render(*product.patches, nullptr, options)
                            : bake::render(product.scene, product.light ? &*product.light : nullptr, options);
  if (product.light && !product.patches && product.light->curve == scene::DisplayCurve::FalseColour) {
    picture = bake::with_legend(picture, 1 / product.light->exposure);
  }
  return writers::write_whole_file(command.preview, bake::png_bytes(picture));
}

std::string write_viewer(const Product& product, const FixCommand& command) {
  if (command.viewer.empty() || !product.light) return {};
  const std::string title = std::filesystem::path(command.input).filename().string();
  return writers::write_whole_file(command.viewer, report::html::viewer_page(product.scene, *product.light, title));
}

Model read_back(const Product& product, const FixCommand& command, const std::string& text) {
  if (command.dry_run) return model_of(product.scene, command.output.empty() ? command.input : command.output);
  return command.output == kStream ? read_model_text(text, command.model) : read_model(command.output, command.model);
}

// The whole of what the plain file holds, decoded again by the reader and judged on its own.
std::string add_twin(const Product& product, const FixCommand& command, const FixJudging& judging,
                     Delivered& delivered) {
  if (!command.draco || command.dry_run) return {};
  const std::string path = draco_twin(command.output);
  std::string problem = writers::writer_for(path)->write(output_of(product), path).problem;
  if (!problem.empty()) return problem;
  delivered.twin = read_model(path, command.model);
  judge_result(*delivered.twin, judging);
  return {};
}

std::uint64_t count_awaited(const Model& model, const FixCommand& command) {
  std::uint64_t awaited = 0;
  if (!command.partial) return awaited;
  for (const scene::Finding& finding : model.report.result.findings) {
    if (finding.severity != scene::Severity::Error) continue;
    if (validate::is_awaited(validate::find_rule(finding.rule)->requirement, command.filters)) ++awaited;
  }
  return awaited;
}

}  // namespace

std::string draco_twin(const std::string& output) {
  return std::filesystem::path(output).replace_extension(".draco.glb").string();
}

validate::Stage stage_reached(const FixCommand& command) {
  if (command.solves()) return validate::Stage::Display;
  return command.meshes() ? validate::Stage::Solve : validate::Stage::Model;
}

Delivered deliver(const Product& product, const FixCommand& command, FixJudging judging, std::ostream& out) {
  Delivered delivered;
  std::string text;
  std::string& problem = delivered.problem;
  if (!command.dry_run) {
    if (command.in_place) problem = keep_original(command.input);
    if (problem.empty() && command.output == kStream) {
      problem = writers::stage_text(output_of(product), text);
    } else if (problem.empty()) {
      problem = write_light_map(product);
      if (problem.empty()) {
        problem = writers::writer_for(command.output)->write(output_of(product), command.output).problem;
      }
    }
  }
  if (problem.empty()) problem = write_preview(product, command);
  if (problem.empty()) problem = write_viewer(product, command);
  if (!problem.empty()) return delivered;
  delivered.model = read_back(product, command, text);
  validate::LintOptions& options = judging.options;
  options.stage = stage_reached(command);
  options.light = false;  // a mesh is fit for a solution whoever lights it; the solver asks for itself
  options.tolerance = {product.lattice.tolerance, geom::ToleranceRequest::Measure::FileUnits};
  judge_result(delivered.model, judging);
  problem = add_twin(product, command, judging, delivered);
  if (!problem.empty()) return delivered;
  delivered.awaited = count_awaited(delivered.model, command);
  out << text << std::flush;
  return delivered;
}

}  // namespace rad::cli
