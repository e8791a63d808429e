#include "report/html/shell.h"

#include <fmt/format.h>

#include "report/html/assets.h"
#include "report/html/escape.h"
#include "report/report.h"

namespace rad::report::html {
namespace {

std::string head(const Shell& shell) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src '{}'; style-src '{}'; "
      "img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"{} {}\">\n<title>{} {} – {}</title>\n<link rel=\"icon\" href=\"data:,\">\n"
      "<style>{}</style>\n</head>\n<body>\n",
      page_script().hash, page_style().hash, escaped(shell.tool), tool_version(), shell.pass ? "✓" : "✗",
      escaped(shell.title), escaped(shell.tool), page_style().text);
}

}  // namespace

std::string whole_page(const Shell& shell) {
  std::string out = head(shell);
  out += fmt::format(
      "<a class=\"skip\" href=\"#findings\">Skip to the findings</a>\n"
      "<header class=\"banner\"><p class=\"tool\">{} {}</p><h1>{}</h1></header>\n<main class=\"work\">\n",
      escaped(shell.tool), tool_version(), escaped(shell.title));
  out += shell.verdict;
  out += "<aside class=\"stage\" hidden></aside>\n<div class=\"rest\">\n" + shell.overview +
         "<div class=\"list\" id=\"findings\" tabindex=\"-1\">\n" + shell.list + "</div>\n</div>\n</main>\n";
  out += fmt::format("<footer><p>Made by {} {}. This file asks nothing of the network.</p></footer>\n",
                     escaped(shell.tool), tool_version());
  out += shell.data + "<script>";
  out += page_script().text;
  return out + "</script>\n</body>\n</html>\n";
}

}  // namespace rad::report::html
