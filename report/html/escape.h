// Putting text of unknown origin into a page, and bytes into text.
#pragma once

#include <string>
#include <string_view>

#include "report/json_parts.h"

namespace rad::report::html {

/// Text as content or as a quoted attribute value: no tag, entity or quote of its own. What is not UTF-8, and control
/// characters but tab and line end, become U+FFFD.
std::string escaped(std::string_view text);

/// JSON for a script element: pure ASCII without '<', '>' and '&', so that nothing in it ends the element or a line.
std::string script_json(const Json& json);

std::string base64(std::string_view bytes);

}  // namespace rad::report::html
