// A line for each finding, in the form that editors and log readers know from compilers.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report {

/// "room.obj:120: error: 3 T-vertices on an edge at (1.25, 0, 3.5) [RL201 t-vertex]", all findings of all inputs, and a
/// last line with their numbers.
std::string concise(const Report& report);

}  // namespace rad::report
