// A view as bytes, to keep it or to pass it from one process to another.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "report/html/model_view.h"

namespace rad::report::html {

/// The same view gives the same bytes.
std::string view_record(const ModelView& view);

/// Nothing where the bytes are none of view_record().
std::optional<ModelView> view_of_record(std::string_view bytes);

}  // namespace rad::report::html
