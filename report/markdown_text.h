// Text of unknown origin inside Markdown as GitHub, GitLab and others read it.
#pragma once

#include <string>
#include <string_view>

namespace rad::report {

/// Reads as it stands, in a paragraph and in a cell of a table: markup and HTML are escaped, nobody is mentioned.
std::string markdown_text(std::string_view text);

/// In the typeface of code; fit for a cell of a table.
std::string markdown_code(std::string_view text);

/// The most that a comment on a pull request may hold with room for what others add, bytes (GitHub: 65 536 characters).
inline constexpr std::size_t kMarkdownLimit = 60'000;

}  // namespace rad::report
