// What a run of radfix did, as JSON.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/radiosity_field.h"
#include "report/changes.h"
#include "report/report.h"
#include "scene/coplanar_removal.h"
#include "scene/ledger.h"

namespace rad::report {

/// Version of this report's shape, semantic versioning.
inline constexpr std::string_view kRepairSchemaVersion = "1.3.0";

/// Counts of the meshes that were made.
struct MeshFigures {
  std::size_t faces = 0;  ///< maximal planar faces that were meshed
  std::size_t patches = 0;
  std::size_t elements = 0;
  std::size_t nodes = 0;
  double patch_size = 0;    ///< longest edge asked for, file units
  double element_size = 0;  ///< file units
  double shape_median = 0;  ///< of the patches: scaled ρ, 1 is best
  double shape_first_percentile = 0;
  std::size_t quads = 0;  ///< of the patches
  /// Patches of faces without a corner below 30 degrees: a sharper one leaves no patch at it in good shape.
  struct Blunt {
    std::size_t patches = 0;
    double shape_median = 0;
    double shape_first_percentile = 0;
  } blunt;
  std::array<std::size_t, 10> shape_histogram{};  ///< patches by ρ: below 0.1, below 0.2, ...
  double patches_per_area = 0;                    ///< file units⁻²
  double elements_per_area = 0;                   ///< file units⁻²
  std::size_t deepest_level = 0;                  ///< of elements: 0 for patches
  double bytes_per_element = 0;                   ///< with its nodes
};

/// The light maps that were written.
struct LightMapFigures {
  std::size_t charts = 0;
  double texel = 0;                ///< longest side of a texel, file units
  std::uint64_t texels = 0;        ///< of all pages
  double clamped_share = 0;        ///< of the area: where a channel is above white
  std::vector<std::string> files;  ///< paths: the atlas, then the pages
};

struct SolutionFigures {
  mesh::EnergyLedger energy;
  std::size_t shots = 0;
  bool complete = true;
  std::optional<double> exposure;  ///< of the displayed colours, m²/W; nothing where none were made
  std::optional<LightMapFigures> light_map;
  std::size_t elements_added = 0;  ///< where the light bends or steps
};

enum class RepairDone : std::uint8_t {
  Not,        ///< the input was refused before
  Skipped,    ///< left out, as the user asked
  NotNeeded,  ///< the input was fit as it was
  Done,
};

/// Area of all faces after a stage, file units².
struct AreaFigure {
  std::string stage;  ///< "input" before the first
  double area = 0;
};

struct RepairReport {
  Report before;                ///< the input as it was read; exactly one input
  std::optional<Report> after;  ///< the written file as it was read back; nothing where nothing was written
  bool dry_run = false;         ///< `after` is what would have been written, judged in memory
  std::vector<std::string> stages_asked;
  std::vector<std::string> stages_done;  ///< whose work is used
  std::uint64_t awaited = 0;             ///< errors of `after` that stages which were not asked for would cure
  RepairDone repair = RepairDone::Not;
  scene::Ledger ledger;
  scene::CoplanarRemovals removals;
  std::vector<AreaFigure> areas;
  std::optional<Changes> changes;        ///< nothing where they were not asked for, or nothing was repaired
  std::optional<Provenance> provenance;  ///< nothing where nothing was written
  std::optional<std::vector<ContractCheck>> contracts;
  std::optional<MeshFigures> mesh;
  std::optional<SolutionFigures> solution;
  scene::StageTimings timings;  ///< empty unless asked for: they change from run to run
  bool incomplete = false;      ///< a stage was stopped before its end
};

/// Before and after summaries, tolerance of the written coordinates, ledger, figures of mesh and solution, timings; as
/// repair_report.schema.json has it.
std::string json(const RepairReport& report);

}  // namespace rad::report
