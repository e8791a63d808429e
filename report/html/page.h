// radlint's report as one HTML file.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report::html {

/// Bytes of models and pictures that a page holds, before they are written as text; what goes beyond is left out, and
/// the page says so.
inline constexpr std::size_t kPageBudget = 9'000'000;

/// A page that needs nothing else and asks for nothing: verdict, requirements, findings, pictures, and, where inputs
/// have a view, the model in three dimensions. All but the last can be read without scripts. The same report gives the
/// same bytes.
std::string page(const Report& report);

}  // namespace rad::report::html
