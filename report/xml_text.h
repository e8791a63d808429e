// Text of unknown origin inside XML.
#pragma once

#include <string>
#include <string_view>

namespace rad::report {

/// Fit for an attribute in double quotes and for character data alike: markup is escaped, and what XML 1.0 has no place
/// for, such as control characters and bytes that are not UTF-8, becomes U+FFFD. Line ends become blanks.
std::string xml_text(std::string_view text);

}  // namespace rad::report
