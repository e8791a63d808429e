// The words of a finding, from the text of its rule.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/finding.h"
#include "validate/rule.h"

namespace rad::validate {

/// A finding with all that a rule says of itself; place, count and message are still open.
scene::Finding finding_frame(const Rule& rule, scene::Severity severity);

scene::Measure measure_of(const Rule& rule, double value, std::optional<double> threshold);

/// The rule's message with its placeholders filled: {n} violations, {s} "" or "s", {one|many} the word for one or for
/// many, {measure}, {limit}, {area}, {advice}, {object} as `in "table", "floor"` (nothing where unnamed), {material} as
/// `"oak", "glass"`, {detail}.
std::string message_of(const Rule& rule, const scene::Finding& finding, std::string_view detail);

}  // namespace rad::validate
