// The part of the text report that lists findings. Only text.cpp includes it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "report/text_layout.h"
#include "scene/finding.h"

namespace rad::report {

struct FindingLayout {
  Paint paint{false};
  std::size_t width = 80;
  std::size_t listed = 10;  ///< for each rule; 0 lists all
};

Ink ink_of(scene::Severity severity);

/// Findings in canonical order, grouped by rule, each rule with a header line and one line on repair.
void append_findings(std::string& out, std::span<const scene::Finding> findings, const FindingLayout& layout);

}  // namespace rad::report
