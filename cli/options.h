// The command lines of both programs, taken apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "bake/atlas.h"
#include "bake/light_map.h"
#include "batch/worker_pool.h"
#include "cli/shard.h"
#include "cli/terminal.h"
#include "config/settings.h"
#include "geom/tolerance.h"
#include "mesh/emesh.h"
#include "mesh/face_patches.h"
#include "readers/choices.h"
#include "repair/surface_order.h"
#include "report/diff_report.h"
#include "report/formats.h"
#include "scene/display_curve.h"
#include "scene/filter.h"
#include "validate/registry.h"
#include "validate/stage.h"

namespace rad::cli {

/// What the pages of rules are written in.
enum class PageFormat : unsigned char { Text, Json, Markdown };

/// What a user says about every model of a run; what is left unsaid comes from the file.
struct ModelOptions {
  std::optional<geom::ToleranceRequest> tolerance;
  std::optional<double> metres_per_unit;
  scene::UpAxis up = scene::UpAxis::Unknown;
  std::size_t jobs = 0;  ///< threads; 0: all that the machine has
  readers::Choices reading;
};

struct FileReport {
  const report::ReportFormat* format = nullptr;  ///< never null once read
  std::string path;
};

/// Which findings are known; empty paths for none.
struct BaselineChoice {
  std::string path;     ///< to be read
  std::string write;    ///< to be made of all that is found
  bool prune = false;   ///< take out of it what does not occur any more
  bool strict = false;  ///< what does not occur any more is an error
};

struct LintCommand {
  std::vector<std::string> paths;
  const report::ReportFormat* format = &report::report_formats().front();  ///< of standard output
  std::vector<FileReport> reports;
  std::vector<std::string> select;
  std::vector<std::string> ignore;
  std::vector<std::string> extend_select;
  std::vector<std::string> extend_ignore;
  std::vector<std::string> severities;    ///< "RL240=note"
  std::optional<validate::Stage> stage;   ///< nothing: as configured, else model
  std::optional<report::FailOn> fail_on;  ///< nothing: as configured, else error
  std::string config;                     ///< the one file of configuration; empty: it is searched for
  bool isolated = false;                  ///< heed no configuration
  ModelOptions model;
  config::Settings settings;  ///< what all of these say about judging, to be put on top of the configuration
  bool group = true;
  std::size_t max_issues = 100;
  std::optional<std::size_t> max_findings;
  ColorChoice color = ColorChoice::Auto;
  bool timings = false;
  bool quiet = false;
  std::vector<std::string> exclude;  ///< patterns of paths below the current folder
  batch::TaskLimits limits;          ///< of each file
  std::string cache;                 ///< folder; empty: the usual one where several files are judged
  bool no_cache = false;
  std::optional<ShardChoice> shard;
  BaselineChoice baseline;
  std::string annotate;  ///< path of a GLB or glTF file that shows what was found; empty for none
};

struct DiffFileReport {
  const report::DiffFormat* format = nullptr;  ///< never null once read
  std::string path;
};

struct DiffCommand {
  std::string old;  ///< a report, a model or a folder
  std::string now;
  const report::DiffFormat* format = &report::diff_formats().front();  ///< of standard output
  std::vector<DiffFileReport> reports;
  LintCommand lint;  ///< how models are judged, and what is listed; its paths, format and reports mean nothing
};

/// What is in force for a model, a folder, or the current folder where no path is named.
struct ConfigCommand {
  LintCommand how;
  PageFormat format = PageFormat::Text;  ///< never Markdown
};

/// One report of several: `paths` of `how` are JSON reports, and it says how to write the result.
struct MergeCommand {
  LintCommand how;
};

struct RuleCommand {
  std::string id;  ///< id or alias; empty: all rules
  PageFormat format = PageFormat::Text;
};

/// A path that stands for standard input or standard output.
inline constexpr std::string_view kStream = "-";

/// Whose edges a picture shows.
enum class DrawnMesh : std::uint8_t { None, Patches, Elements };

/// Where a picture is taken from and what is in its middle, file units.
struct ViewLine {
  geom::dvec3 from{0, 0, 0};
  geom::dvec3 to{0, 0, 0};
};

/// Where the light of a solution is shown.
enum class BakeMode : std::uint8_t { Vertex, LightMap, Emissive };

/// Patches of objects or materials whose names fit the pattern have another length.
struct PatchSizeOf {
  std::string pattern;  ///< as in a shell
  double length = 0;    ///< file units
};

struct FixCommand {
  std::string input;     ///< kStream for standard input
  std::string output;    ///< kStream for standard output; empty under dry_run where none was named
  std::string annotate;  ///< path of a GLB or glTF file that shows what was done; empty for none
  ModelOptions model;
  LintCommand judging;                          ///< the configuration to heed, and what the command line puts on top
  scene::FilterSet filters;                     ///< to run
  bool partial = false;                         ///< --only or --until: what later filters cure is no failure
  std::vector<const validate::Rule*> fix_only;  ///< rules that alone are to be cured; empty for all
  bool dry_run = false;                         ///< write no model
  bool diff = false;                            ///< say what changed, place by place
  bool check_contracts = false;                 ///< judge between the filters (paper, Table 2)
  bool unsafe_fixes = false;                    ///< leave out faces that cannot be kept
  std::vector<FileReport> reports;
  bool in_place = false;  ///< the output is the input, which is kept as .orig
  repair::CoplanarOptions coplanar;
  std::vector<std::string> two_sided;  ///< patterns of objects and materials whose faces are doubled
  bool cap_planar = false;             ///< close flat openings
  std::vector<PatchSizeOf> patch_sizes;
  mesh::PatchMethod patch_method = mesh::PatchMethod::Grid;
  mesh::ShadowSearch shadow_search = mesh::ShadowSearch::Silhouettes;
  std::optional<double> shadow_size;         ///< longest element edge where shadows end; nothing: half the element size
  std::string dump_hemicube;                 ///< path of an OpenEXR file; empty for none
  std::optional<double> patch_size;          ///< longest patch edge, file units; nothing: from the area of the model
  std::optional<double> element_size;        ///< longest element edge, file units; nothing: a quarter of the patch size
  std::uint32_t refine_levels = 4;           ///< times that elements are divided where the light bends or steps
  std::optional<std::size_t> most_elements;  ///< leaves in the end; nothing: half more than before, and 20 000
  std::optional<double> exposure;            ///< of displayed colours, m²/W; nothing: automatic
  scene::DisplayCurve curve = scene::DisplayCurve::Linear;
  BakeMode bake = BakeMode::Vertex;
  std::optional<double> texel;  ///< longest side of a texel of a light map, file units; nothing: chosen
  std::uint32_t page_size = bake::kDefaultPageSize;  ///< longest side of a page, texels
  bake::StoredQuantity stored = bake::StoredQuantity::Exitance;
  DrawnMesh drawn_mesh = DrawnMesh::None;
  std::string preview;             ///< path of a PNG picture; empty for none
  std::optional<ViewLine> camera;  ///< of the picture; nothing: chosen
  std::string viewer;              ///< path of an HTML page that shows the solution; empty for none
  bool timings = false;
  bool draco = false;  ///< write a compressed twin beside the GLB

  [[nodiscard]] bool repairs() const { return !filters.common(scene::kRepairFilters).empty(); }
  [[nodiscard]] bool meshes() const { return filters.has(scene::Filter::Pmesh); }
  [[nodiscard]] bool solves() const { return filters.has(scene::Filter::Solve); }
  [[nodiscard]] bool maps_light() const { return bake != BakeMode::Vertex; }
};

/// Nothing more to do: help or version on standard output, or a usage error on standard error.
struct Stop {
  int exit_code = 0;
  std::string out;
  std::string err;
};

/// `args` are without the program's name.
std::variant<LintCommand, RuleCommand, DiffCommand, MergeCommand, ConfigCommand, Stop> parse_radlint(
    std::span<const std::string> args);
std::variant<FixCommand, Stop> parse_radfix(std::span<const std::string> args);

}  // namespace rad::cli
