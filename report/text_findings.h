// The part of the text report that lists findings. text.cpp and repair_text.cpp include it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "report/text_layout.h"
#include "scene/finding.h"

namespace rad::report {

struct FindingLayout {
  Paint paint{false};
  std::size_t width = 80;
  std::size_t listed = 10;                                    ///< for each rule; 0 lists all
  std::string_view elsewhere = "--max-findings 0 shows all";  ///< where the others are
};

Ink ink_of(scene::Severity severity);

/// Findings in canonical order, grouped by rule, each rule with a header line and one line on repair.
void append_findings(std::string& out, std::span<const scene::Finding> findings, const FindingLayout& layout);

}  // namespace rad::report
