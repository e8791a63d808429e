// The lines of the text report that say what a file holds. Only text.cpp includes it.
#pragma once

#include <string>

#include "report/report.h"
#include "report/text_layout.h"

namespace rad::report {

/// Path, contents, size, tolerance, unit and up axis of a file.
void append_header(std::string& out, const InputReport& input, const Paint& paint, std::size_t width);

/// "T 0.0002 m = 0.2 mm (default)"
std::string tolerance_text(const geom::Tolerance& tolerance, std::optional<double> metres_per_unit);

}  // namespace rad::report
