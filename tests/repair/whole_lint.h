// The lint of triangles that do not change, all at once.
#pragma once

#include <vector>

#include "repair/triangle_lint.h"

namespace rad::tests {

inline std::vector<std::uint32_t> living(const repair::TriangleSet& set) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < set.triangles.size(); ++i) {
    if (set.is_alive(i)) all.push_back(i);
  }
  return all;
}

inline std::vector<repair::Violation> lint_triangles(const repair::TriangleSet& set, std::int64_t tolerance) {
  repair::TriangleLint lint(tolerance);
  lint.update(set, living(set));
  return lint.violations(set);
}

/// Those of start(); update_contacts() must find the same after update().
inline std::vector<repair::Violation> lint_contacts(const repair::TriangleSet& set, std::int64_t tolerance) {
  repair::TriangleLint at_once(tolerance);
  at_once.start(set, living(set));
  return at_once.contacts();
}

}  // namespace rad::tests
