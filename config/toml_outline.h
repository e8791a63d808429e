// TOML text made fit for its parser.
//
// toml++ 3.3 nests a table for each part of a dotted name without limit, and its behaviour is undefined for letters
// beyond ASCII wherever it looks for the end of a value. It gets neither.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rad::config {

struct AsciiToml {
  std::string text;        ///< the same lines in ASCII; texts in it are to be read with plain_text()
  std::uint64_t line = 0;  ///< 1-based, of what is refused; 0: nothing is
  std::string fault;       ///< why, in a clause
};

/// Bytes beyond ASCII, and percent signs, become %XX in strings and question marks in comments. Refused are those
/// elsewhere, where TOML does not allow them, and unquoted runs of more than `most_dots` dots ("a.b.c = 1", "[a.b.c]").
AsciiToml ascii_toml(std::string_view text, int most_dots);

/// A text of the document, with %XX turned back into bytes.
std::string plain_text(std::string_view text);

}  // namespace rad::config
