// Text of unknown origin, such as names in a model, made fit to stand in a report of any format.
#pragma once

#include <string>
#include <string_view>

namespace rad::report {

/// Valid UTF-8 on one line. Tab, line ends and the separators of lines and paragraphs become a blank; other control
/// characters (C0, C1), marks that change the direction of writing, and what is no character become U+FFFD.
std::string printable(std::string_view text);

/// `text` with every occurrence of a character of `special` preceded by a backslash.
std::string with_backslashes(std::string_view text, std::string_view special);

/// At most `bytes` bytes, cut between characters, with "…" where something was left out. `text` is valid UTF-8.
std::string shortened(std::string text, std::size_t bytes);

}  // namespace rad::report
