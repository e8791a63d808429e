// Pieces that the JSON reports of both programs share. Only .cpp files of this folder include it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "report/report.h"

namespace rad::report {

/// Keys keep the order in which they are written.
using Json = nlohmann::ordered_json;

/// A finite number without negative zero; null for what JSON has no number for.
Json number(double value);
Json point_json(const geom::dvec3& point);

/// {name, version}
Json tool_json(std::string_view tool);
/// {T, source, diagonal}; null where nothing could be read.
Json tolerance_json(const InputReport& input);
/// The tolerance of the only input; null where there are several.
Json only_tolerance_json(const Report& report);
/// Path, format, units, figures and tolerance of an input.
Json input_json(const InputReport& input);
/// The same of each input, with what differs from the others and what is not listed.
Json inputs_json(const Report& report);
/// {errors, warnings, notes, byRule, requirements}
Json summary_json(const Report& report);
/// Seconds for each step, summed over inputs; {} unless asked for.
Json timings_json(const Report& report, bool with_timings);

/// The whole report of radlint.
Json report_json(const Report& report, bool with_timings);

/// Text of two-space indentation with a final line end. Bytes that are not UTF-8 become U+FFFD.
std::string written(const Json& json);
/// The same without indentation: one line.
std::string written_on_one_line(const Json& json);

}  // namespace rad::report
