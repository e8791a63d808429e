// Lines of sight as a model that a modeller opens beside the one that was judged.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report {

/// OBJ with one polyline (`l`) for every segment of an invalid facade (RL113), from what is lit to the back that is
/// seen, in the coordinates of the file; the name of its object says which finding it belongs to. Without such findings
/// it holds comments only.
std::string leak_lines(const Report& report);

}  // namespace rad::report
