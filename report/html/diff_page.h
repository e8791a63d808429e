// A comparison of two judgements as one HTML file.
#pragma once

#include <string>

#include "report/diff.h"

namespace rad::report::html {

/// A page like that of a report: the verdict, what is new, changed, fixed and unchanged in every model, and both models
/// side by side under one camera where their inputs have views. The same comparison gives the same bytes.
std::string page(const Diff& diff);

}  // namespace rad::report::html
