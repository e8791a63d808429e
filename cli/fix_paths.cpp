#include "cli/fix_paths.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <span>
#include <vector>

#include "cli/annotated_scene.h"
#include "cli/deliver.h"
#include "cli/light_map_stage.h"
#include "writers/registry.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path one = fs::weakly_canonical(fs::absolute(a, error), error);
  const fs::path other = fs::weakly_canonical(fs::absolute(b, error), error);
  return !one.empty() && one == other;
}

std::string input_problem(const std::string& input) {
  if (input == kStream) return {};
  std::error_code error;
  if (!fs::exists(input, error)) return input + ": no such file";
  return fs::is_directory(input, error) ? input + ": is a folder; name one model file" : std::string();
}

std::string output_problem(const FixCommand& command) {
  const std::string& output = command.output;
  if (output.empty()) return {};
  const writers::Writer* const writer = writers::writer_for(output);
  const bool between_filters = output == kStream || (writer != nullptr && writer->between_filters);
  if (between_filters && command.meshes()) {
    return output + ": a stage file holds models up to orient; give a mesh another format";
  }
  if (writer != nullptr && command.maps_light() && !(writer->carries_light && writer->holds.images)) {
    return output + ": holds no light map; give a name that ends in .glb or .gltf";
  }
  if (between_filters || writer != nullptr) return {};
  return output + ": not a format that is written; give a name that ends in one of " + writers::writable_extensions();
}

std::string preview_problem(const std::string& preview) {
  std::string extension = fs::path(preview).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return preview.empty() || extension == ".png" ? std::string() : preview + ": pictures are PNG; end its name in .png";
}

std::string draco_problem(const FixCommand& command) {
  if (!command.draco) return {};
  std::string name = command.in_place ? command.input : command.output;
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  if (name.ends_with(".glb") && !name.ends_with(".draco.glb")) return {};
  return "--draco: writes a twin beside a .glb; name such an output";
}

// An earlier original must not be lost.
std::string original_problem(const FixCommand& command) {
  std::error_code error;
  for (const fs::path& path : {fs::path(command.input), fs::path(command.input).replace_extension(".mtl")}) {
    const std::string original = path.string() + ".orig";
    if (command.in_place && fs::exists(path, error) && fs::exists(original, error)) {
      return original + ": is there already; move it away first";
    }
  }
  return {};
}

std::string folder_problem(const std::string& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) return file + ": is a folder; name a file";
  const fs::path folder = fs::path(file).parent_path();
  if (folder.empty() || fs::is_directory(folder, error)) return {};
  return file + ": there is no folder " + folder.string();
}

struct NamedPath {
  const char* what;
  const std::string& path;
};

std::string place_problem(const std::string& input, std::span<const NamedPath> written) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    const std::string& path = written[i].path;
    if (path.empty() || path == kStream) continue;
    if (std::string problem = folder_problem(path); !problem.empty()) return problem;
    if (same_file(path, input)) return path + ": is the input; name another file";
    for (std::size_t j = 0; j < i; ++j) {
      if (!written[j].path.empty() && same_file(path, written[j].path)) {
        return path + ": is the " + written[j].what + " as well; name another file for the " + written[i].what;
      }
    }
  }
  return {};
}

}  // namespace

std::string fix_path_problem(const FixCommand& command) {
  std::string problem = input_problem(command.input);
  if (problem.empty()) problem = output_problem(command);
  if (problem.empty()) problem = draco_problem(command);
  if (problem.empty()) problem = preview_problem(command.preview);
  if (problem.empty()) problem = annotation_problem(command.annotate);
  if (problem.empty()) problem = original_problem(command);
  if (!problem.empty()) return problem;
  static const std::string kNowhere;
  const std::string twin = command.draco ? draco_twin(command.output) : kNowhere;
  const std::string atlas =
      command.maps_light() && !command.output.empty() ? atlas_path(command.output).string() : kNowhere;
  std::vector<NamedPath> written{{"output", command.in_place ? kNowhere : command.output},
                                 {"Draco twin", twin},
                                 {"preview", command.preview},
                                 {"viewer", command.viewer},
                                 {"annotated model", command.annotate},
                                 {"hemi-cube", command.dump_hemicube},
                                 {"atlas", atlas}};
  for (const FileReport& report : command.reports) written.push_back({"report", report.path});
  return place_problem(command.input, written);
}

}  // namespace rad::cli
