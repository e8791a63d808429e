#include "report/html/markup.h"

#include <fmt/format.h>

#include "report/html/escape.h"

namespace rad::report::html {
namespace {

std::string_view outline(Sign sign) {
  switch (sign) {
    case Sign::Diamond:
      return R"(<path d="M8 .8 15.2 8 8 15.2.8 8z"/>)";
    case Sign::Triangle:
      return R"(<path d="M8 1.4 15.3 14H.7z"/>)";
    case Sign::Disc:
      return R"(<circle cx="8" cy="8" r="6.4"/>)";
    case Sign::Tick:
      return R"(<path class="line" d="m2 8.6 4.2 4.2L14 3.6"/>)";
    case Sign::Blank:
      return R"(<path class="line" d="M4 8h8"/>)";
  }
  return {};
}

Sign sign_of(scene::Severity severity) {
  switch (severity) {
    case scene::Severity::Error:
      return Sign::Diamond;
    case scene::Severity::Warning:
      return Sign::Triangle;
    case scene::Severity::Note:
      break;
  }
  return Sign::Disc;
}

}  // namespace

std::string sign(Sign sign) {
  return fmt::format(R"(<svg class="sign" viewBox="0 0 16 16" aria-hidden="true">{}</svg>)", outline(sign));
}

std::string severity_sign(scene::Severity severity) {
  return fmt::format(R"(<span class="severity {0}">{1}<span>{0}</span></span>)", scene::name(severity),
                     sign(sign_of(severity)));
}

std::string image(const Picture& picture, std::string_view text_instead, std::string_view css_class) {
  if (picture.png.empty()) return {};
  return fmt::format(R"(<img class="{}" width="{}" height="{}" alt="{}" src="data:image/png;base64,{}">)", css_class,
                     picture.width, picture.height, escaped(text_instead), base64(picture.png));
}

std::string finding_id(std::size_t input, std::size_t finding) { return fmt::format("f-{}-{}", input, finding); }

std::string rule_anchor(std::size_t input, const scene::Finding& finding) {
  return fmt::format("r-{}-{}-{}", input, finding.rule, scene::name(finding.severity));
}

}  // namespace rad::report::html
