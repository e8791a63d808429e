// What a command says about patches and elements, as the mesher takes it, and what is said of the result.
#pragma once

#include "cli/options.h"
#include "mesh/emesh.h"
#include "mesh/pmesh.h"
#include "report/repair_report.h"
#include "solve/solver.h"

namespace rad::cli {

/// `origin` is the scene whose names the command's patterns mean and whose materials emit; it must outlive the result.
/// `problem` names a pattern that fits nothing.
mesh::PatchOptions patch_options(const FixCommand& command, const scene::ConformingModel& model,
                                 const scene::Scene& origin, std::string& problem);

mesh::EmeshOptions emesh_options(const FixCommand& command, double patch_size, const scene::Scene& origin);

/// `finest` is the shadow size: texels of light maps are fitted to it, so with these no element becomes smaller.
solve::RefineOptions refine_options(const FixCommand& command, const mesh::ElementMesh& elements, double finest);

report::MeshFigures mesh_figures(const mesh::PatchMesh& patches, const mesh::ElementMesh& elements,
                                 const mesh::PatchOptions& patch_options, const mesh::EmeshOptions& emesh_options);

}  // namespace rad::cli
