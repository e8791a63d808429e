// Tables 1 and 2 of the paper made executable: how severe a broken requirement is at a stage of the pipeline.
#pragma once

#include <optional>
#include <string_view>

#include "validate/rule.h"

namespace rad::validate {

/// Model: what Table 2 asks after Coplanar. The others are the columns of Table 1.
enum class Stage : std::uint8_t { Model, Preprocess, Solve, Display };

std::optional<Stage> parse_stage(std::string_view text);
std::string_view name(Stage stage);

/// Severity of a finding of violations that are grave; elsewhere that of the others.
std::optional<scene::Severity> grave_severity_at(const Rule& rule, Stage stage);

/// Severity of a finding of this rule at this stage; nothing where the stage does not ask for the requirement.
std::optional<scene::Severity> severity_at(const Rule& rule, Stage stage);

}  // namespace rad::validate
