#include "cli/rule_pages.h"

#include "cli/exit_code.h"
#include "cli/nearest.h"
#include "report/rule_page.h"

namespace rad::cli {

namespace {

std::string page(const validate::Rule& rule, Format format, std::size_t width) {
  switch (format) {
    case Format::Text:
      return report::rule_text(rule, width);
    case Format::Json:
      return report::rule_json(rule);
    case Format::Markdown:
      return report::rule_markdown(rule);
    case Format::Html:
    case Format::LeakLine:
      break;  // of findings, not of rules
  }
  return {};
}

std::string list(Format format, std::size_t width) {
  const auto rules = validate::all_rules();
  switch (format) {
    case Format::Text:
      return report::rules_text(rules, width);
    case Format::Json:
      return report::rules_json(rules);
    case Format::Markdown:
      return report::rules_markdown(rules);
    case Format::Html:
    case Format::LeakLine:
      break;
  }
  return {};
}

}  // namespace

int run_rule_pages(const RuleCommand& command, std::ostream& out, std::ostream& err, std::size_t width) {
  if (command.id.empty()) {
    out << list(command.format, width);
    return kClean;
  }
  const validate::Rule* rule = validate::find_rule(command.id);
  if (rule == nullptr) {
    err << "radlint: no rule is called '" << command.id << "'" << did_you_mean(validate::nearest_selector(command.id))
        << " (radlint rules lists all)\n";
    return kUsage;
  }
  out << page(*rule, command.format, width);
  return kClean;
}

}  // namespace rad::cli
