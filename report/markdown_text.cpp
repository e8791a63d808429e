#include "report/markdown_text.h"

#include "report/printable.h"

namespace rad::report {

std::string markdown_text(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '@') {
      out += "@<!-- -->";
    } else {
      if (std::string_view("\\`*_[]|#~&$").find(c) != std::string_view::npos) out += '\\';
      out += c;
    }
  }
  return out;
}

std::string markdown_code(std::string_view text) {
  std::string out = "`";
  for (const char c : printable(text)) {
    if (c == '|') out += '\\';
    out += c == '`' ? '\'' : c;
  }
  return out + '`';
}

}  // namespace rad::report
