// A finding as JSON, the same in both reports.
#pragma once

#include <optional>

#include "report/json_parts.h"
#include "scene/finding.h"

namespace rad::report {

/// As report.schema.json has it. `input_index` is that of its input in the report.
Json finding_json(const scene::Finding& finding, std::size_t input_index, std::optional<double> metres_per_unit);

/// A face as a user finds it.
Json face_json(const scene::FaceReference& face);

}  // namespace rad::report
