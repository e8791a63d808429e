#include "cli/convert.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/carried_images.h"
#include "cli/convert_faces.h"
#include "cli/exit_code.h"
#include "cli/judge.h"
#include "readers/components.h"
#include "readers/reader.h"
#include "report/printable.h"
#include "writers/registry.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

const char* corners_word(writers::Corners corners) {
  switch (corners) {
    case writers::Corners::Three:
      return "triangles";
    case writers::Corners::Four:
      return "quads";
    case writers::Corners::Any:
      return "polygons";
  }
  return "";
}

std::string list_text() {
  const auto mark = [](bool held) { return held ? "yes" : "-"; };
  std::string text =
      fmt::format("{:<12}{:<11}{:<7}{:<9}{:<8}{:<11}{:<13}{:<10}{:<8}{:<6}{}\n", "Written", "Faces", "Holes", "Objects",
                  "Groups", "Materials", "Reflectance", "Emission", "Images", "Unit", "Precision");
  for (const writers::Writer& writer : writers::all_writers()) {
    const writers::Holds& holds = writer.holds;
    text += fmt::format("{:<12}{:<11}{:<7}{:<9}{:<8}{:<11}{:<13}{:<10}{:<8}{:<6}{}\n", writer.name,
                        corners_word(holds.corners), mark(holds.holes), mark(holds.objects), mark(holds.groups),
                        mark(holds.materials), mark(holds.reflectance), mark(holds.emission), mark(holds.images),
                        mark(holds.unit), holds.doubles ? "double" : "single");
  }
  text += "\nRead:";
  for (const std::string_view suffix : readers::model_suffixes()) text += fmt::format(" {}", suffix);
  text += '\n';
  for (const readers::Component& component : readers::components()) {
    text += component.version.empty()
                ? fmt::format("{} would be read through {}, which is not there\n", component.formats, component.name)
                : fmt::format("{} through {} {}\n", component.formats, component.name, component.version);
  }
  return text;
}

std::string path_problem(const ConvertCommand& command) {
  std::error_code error;
  if (!fs::exists(command.input, error)) return command.input + ": no such file";
  if (fs::is_directory(command.input, error)) return command.input + ": is a folder; name one model file";
  if (fs::equivalent(command.input, command.output, error)) return command.output + ": is the input";
  const writers::Writer* const writer = writers::writer_for(command.output);
  if (writer == nullptr || writer->between_filters) {
    return command.output + ": not a format that convert writes; give a name that ends in one of " +
           writers::writable_extensions();
  }
  return {};
}

class Conversion {
 public:
  Conversion(const ConvertCommand& command, std::ostream& out, std::ostream& err)
      : command_(command), out_(out), err_(err), writer_(*writers::writer_for(command.output)) {}

  int run() {
    model_ = read_model(command_.input, command_.model);
    say_issues();
    if (!model_.report.read) return fail(kUsage, command_.input + ": cannot be read");
    if (model_.content.scene.faces.empty())
      return fail(kRefused, command_.input + ": no surface in it; nothing was written");
    std::vector<std::string> losses = writers::losses_of(model_.content.scene, writer_.holds);
    ConvertedFaces faces = faces_for(model_.content.scene, writer_.triangles_only, command_.model.tolerance);
    if (!faces.problem.empty()) return fail(kUsage, command_.input + ": " + faces.problem);
    if (faces.left_out > 0)
      losses.push_back(fmt::format("{} faces without area or with crossing outlines", faces.left_out));
    if (const std::string problem = bring_images(faces.scene, command_.input, command_.output); !problem.empty()) {
      return fail(kUsage, problem);
    }
    const writers::Output output{.scene = faces.scene, .lattice = faces.scene.recorded};
    if (const auto result = writer_.write(output, command_.output); !result.ok()) {
      return fail(kUsage, command_.output + ": " + result.problem);
    }
    say_result(faces.scene, losses);
    return kClean;
  }

 private:
  int fail(int exit_code, const std::string& what) {
    err_ << "radfix: " << what << '\n';
    return exit_code;
  }

  // What the reader could not take over is lost as well.
  void say_issues() {
    constexpr std::size_t kShown = 10;
    const auto& issues = model_.content.issues.all();
    for (std::size_t i = 0; i < std::min(issues.size(), kShown); ++i) {
      const scene::ReadIssue& issue = issues[i];
      std::string place = issue.place.pointer.empty() ? std::string() : "#" + issue.place.pointer;
      if (issue.place.line > 0) place = fmt::format(":{}", issue.place.line);
      err_ << fmt::format("radfix: {}{}: {}{}\n", command_.input, report::printable(place),
                          report::printable(issue.what),
                          issue.count > 1 ? fmt::format(" ({} times)", issue.count) : std::string());
    }
    if (issues.size() > kShown) err_ << fmt::format("radfix: and {} more\n", issues.size() - kShown);
  }

  void say_result(const scene::Scene& written, const std::vector<std::string>& losses) {
    out_ << fmt::format("{}: {} faces, {} written as {}\n", command_.output, model_.content.scene.faces.size(),
                        written.faces.size(), writer_.name);
    for (const std::string& loss : losses) out_ << fmt::format("  lost: {}\n", loss);
    if (losses.empty()) out_ << "  nothing is lost\n";
  }

  const ConvertCommand& command_;
  std::ostream& out_;
  std::ostream& err_;
  const writers::Writer& writer_;
  Model model_;
};

}  // namespace

int run_convert(std::span<const std::string> args, std::ostream& out, std::ostream& err) {
  const auto parsed = parse_convert(args);
  if (const Stop* stop = std::get_if<Stop>(&parsed)) {
    out << stop->out << std::flush;
    err << stop->err;
    return stop->exit_code;
  }
  const ConvertCommand& command = std::get<ConvertCommand>(parsed);
  if (command.list) {
    out << list_text() << std::flush;
    return kClean;
  }
  if (const std::string problem = path_problem(command); !problem.empty()) {
    err << "radfix: " << problem << '\n';
    return kUsage;
  }
  return Conversion(command, out, err).run();
}

}  // namespace rad::cli
