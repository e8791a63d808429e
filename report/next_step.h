// What to type next.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report {

/// A command with, in brackets, what it is for; two lines where both repair and an explanation help.
std::string next_step(const Report& report);

}  // namespace rad::report
