// From the product to the file, and the verdict on what the file holds.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "cli/fix_judging.h"
#include "cli/fix_stages.h"

namespace rad::cli {

/// What was written and read back, or what would have been.
struct Delivered {
  std::optional<Model> twin;  ///< of --draco, judged as the model is
  Model model;                ///< judged at the stage that the command reaches
  std::uint64_t awaited = 0;  ///< errors that filters which the command left for later would cure
  std::string problem;        ///< why nothing was written; then the rest is empty
};

/// Where the compressed twin of a GLB is written: out.draco.glb for out.glb.
std::string draco_twin(const std::string& output);

/// The stage that a run reaches: model, with a mesh solve, with a solution display.
validate::Stage stage_reached(const FixCommand& command);

/// Writes the product and judges what was written, as `judging` has it but for stage and tolerance; under --dry-run
/// judges what would have been. A model for standard output goes to `out`.
Delivered deliver(const Product& product, const FixCommand& command, FixJudging judging, std::ostream& out);

}  // namespace rad::cli
