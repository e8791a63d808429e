// The findings of an input as they are read: by rule, the worst first.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report::html {

/// Heading, figures, picture and findings of an input. `view` is what may be shown of it, null for nothing; `room` says
/// why there is none.
std::string model_section(const Report& report, std::size_t input, const ModelView* view, std::string_view room);

}  // namespace rad::report::html
