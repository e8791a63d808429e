// What every page has around its contents.
#pragma once

#include <string>

namespace rad::report::html {

/// Markup, but for the first two, which are text.
struct Shell {
  std::string tool;
  std::string title;
  bool pass = true;
  std::string verdict;   ///< beside the 3-D view, or above it
  std::string overview;  ///< between the verdict and the findings
  std::string list;      ///< the findings
  std::string data;      ///< script elements that hold data
};

/// Head with the Content-Security-Policy, style, contents, script.
std::string whole_page(const Shell& shell);

}  // namespace rad::report::html
