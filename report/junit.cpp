#include "report/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/place_text.h"
#include "report/text.h"
#include "report/text_layout.h"
#include "report/xml_text.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

using validate::Rule;

constexpr std::size_t kListed = 20;  // findings in the text of a failure

struct Tally {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t skipped = 0;

  Tally& operator+=(const Tally& other) {
    tests += other.tests;
    failures += other.failures;
    errors += other.errors;
    skipped += other.skipped;
    return *this;
  }
  [[nodiscard]] std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"", tests, failures, errors, skipped);
  }
};

// Folders become what packages are to a build server, and the dot of the suffix no boundary of one.
std::string class_name(std::string_view path) {
  std::string name = relative_path(path, {});
  std::ranges::replace(name, '.', '_');
  std::ranges::replace(name, '/', '.');
  return xml_text(name);
}

std::string listing(const std::vector<const scene::Finding*>& findings) {
  std::string out;
  for (std::size_t i = 0; i < std::min(findings.size(), kListed); ++i) {
    const scene::Finding& finding = *findings[i];
    const std::string point = point_text(finding.where);
    out += fmt::format("{}: {}{}\n", xml_text(place_text(finding.where)), xml_text(finding.message),
                       point.empty() ? "" : " at " + point);
  }
  if (findings.size() > kListed) out += fmt::format("… {} more\n", findings.size() - kListed);
  if (const std::string fix = fix_text(findings.front()->fix); !fix.empty()) out += fmt::format("fix: {}\n", fix);
  return out;
}

class Suite {
 public:
  Suite(const InputReport& input, FailOn fail_on, bool timings) : input_(input), fail_on_(fail_on), timings_(timings) {
    for (const scene::Finding& finding : input.result.findings) findings_[finding.rule].push_back(&finding);
  }

  std::string run() {
    for (const Rule* rule : validate::all_rules()) add_case(*rule);
    if (!input_.result.incomplete.empty()) {
      add("judged to the end", {},
          element("error", "judged in part", "incomplete", xml_text(input_.result.incomplete)));
      ++tally_.errors;
    }
    const std::string name = xml_text(input_.path);
    return fmt::format("  <testsuite name=\"{0}\" {1}{2} file=\"{0}\">\n{3}  </testsuite>\n", name, tally_.attributes(),
                       time_of({}), cases_);
  }

  [[nodiscard]] const Tally& tally() const { return tally_; }

 private:
  void add_case(const Rule& rule) {
    const std::string name = fmt::format("{} {}", rule.id, rule.alias);
    const auto found = findings_.find(rule.id);
    if (found != findings_.end()) {
      add(name, rule.id, outcome(found->second));
    } else if (std::ranges::find(input_.result.checked, &rule) == input_.result.checked.end()) {
      ++tally_.skipped;
      add(name, rule.id, "<skipped message=\"not asked for\"/>");
    } else {
      add(name, rule.id, {});
    }
  }

  std::string outcome(const std::vector<const scene::Finding*>& findings) {
    Counts sum;
    for (const scene::Finding* finding : findings) sum.add(finding->severity);
    const std::string message = counts_text(sum);
    if (!input_.read) {
      ++tally_.errors;
      return element("error", message, "unreadable", listing(findings));
    }
    if (!reaches(sum, fail_on_)) return fmt::format("<system-out>{}: {}</system-out>", message, listing(findings));
    ++tally_.failures;
    return element("failure", message, scene::name(findings.front()->severity), listing(findings));
  }

  static std::string element(std::string_view kind, std::string_view message, std::string_view type,
                             std::string_view text) {
    return fmt::format("<{0} message=\"{1}\" type=\"{2}\">{3}</{0}>", kind, message, type, text);
  }

  void add(std::string_view name, std::string_view rule, const std::string& content) {
    ++tally_.tests;
    std::string place = fmt::format(" file=\"{}\"", xml_text(input_.path));
    if (const auto found = findings_.find(rule); found != findings_.end() && found->second.front()->where.line > 0) {
      place = fmt::format(" file=\"{}\" line=\"{}\"", xml_text(found->second.front()->where.file),
                          found->second.front()->where.line);
    }
    const std::string head = fmt::format("    <testcase name=\"{}\" classname=\"{}\"{}{}", name,
                                         class_name(input_.path), place, time_of(rule));
    cases_ += content.empty() ? head + "/>\n" : fmt::format("{}>{}</testcase>\n", head, content);
  }

  // Of one step, or of all.
  [[nodiscard]] std::string time_of(std::string_view step) const {
    if (!timings_) return {};
    double seconds = 0;
    for (const auto& [name, taken] : input_.result.timings) {
      if (step.empty() || name == step) seconds += taken;
    }
    return fmt::format(" time=\"{:.6f}\"", seconds);
  }

  const InputReport& input_;
  FailOn fail_on_;
  bool timings_;
  std::map<std::string_view, std::vector<const scene::Finding*>> findings_;
  Tally tally_;
  std::string cases_;
};

}  // namespace

std::string junit(const Report& report, bool with_timings) {
  std::string suites;
  Tally total;
  for (const InputReport& input : report.inputs) {
    Suite suite(input, report.fail_on, with_timings);
    suites += suite.run();
    total += suite.tally();
  }
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" {}>\n{}</testsuites>\n",
                     report.tool, total.attributes(), suites);
}

}  // namespace rad::report
