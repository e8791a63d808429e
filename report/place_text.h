// Where a finding is, in words that several formats share.
#pragma once

#include <string>
#include <string_view>

#include "report/report.h"

namespace rad::report {

/// "room.obj:120", "room.glb#/meshes/3", "room.stl byte 84", "room.obj"
std::string place_text(const scene::Where& where);

/// "(1.25, 0, 3.5)"; empty where the fault has no place in space.
std::string point_text(const scene::Where& where);

/// "(1.25, 0, 3.5) m": with the unit of the file, "units" where it is not known.
std::string point_text(const scene::Where& where, const InputReport& input);

/// A path relative to `root` where it lies in it, else as it is; with / between folders and without ./ at its start.
std::string relative_path(std::string_view path, std::string_view root);

}  // namespace rad::report
