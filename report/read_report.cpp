#include "report/read_report.h"

#include <algorithm>
#include <array>

#include "report/merge.h"
#include "report/read_parts.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

constexpr std::string_view kOldestSchema = "1.1.0";  // without suppressions
constexpr std::array kReadable = {kOldestSchema, std::string_view("1.2.0"), kSchemaVersion};

bool is_readable(std::string_view version) { return std::ranges::find(kReadable, version) != kReadable.end(); }

validate::Stage read_stage(const Json& json) {
  const auto& text = json.get_ref<const std::string&>();
  if (const auto stage = validate::parse_stage(text)) return *stage;
  throw UnknownShape("stage '" + text + "' is not known to this version");
}

Shard read_shard(const Json& json) {
  return {json.at("index").get<std::size_t>(), json.at("count").get<std::size_t>(), json.at("files").get<std::size_t>(),
          json.at("positions").get<std::vector<std::size_t>>()};
}

void read_invocation(const Json& json, Report& report) {
  report.stage = read_stage(json.at("stage"));
  report.fail_on = named(json.at("failOn"), FailOn::Error, FailOn::Warning, FailOn::Note, FailOn::Never);
  report.select = json.at("select").get<std::vector<std::string>>();
  report.ignore = json.at("ignore").get<std::vector<std::string>>();
  if (const auto shard = json.find("shard"); shard != json.end()) report.shard = read_shard(*shard);
}

std::vector<const validate::Rule*> read_checked(const Json& all, const Json& unchecked) {
  std::vector<const validate::Rule*> checked;
  for (const Json& id : all) {
    if (std::ranges::find(unchecked, id) == unchecked.end()) checked.push_back(&rule_of(id));
  }
  return checked;
}

Unlisted read_unlisted(const Json& json) {
  const validate::Rule& rule = rule_of(json.at("rule"));
  return {rule.id, validate::code(rule.requirement), read_severity(json.at("severity")),
          json.at("places").get<std::uint64_t>(), json.at("findings").get<std::uint64_t>()};
}

// Reports before 1.3.0 only count what is suppressed.
void read_suppressed(const Json& json, Report& report) {
  const auto all = json.find("suppressed");
  if (all == json.end()) return;
  for (const Json& entry : *all) {
    const Json& finding = entry.at("finding");
    validate::LintResult& result = report.inputs.at(finding.at("input").get<std::size_t>()).result;
    const auto by = entry.at("by").get<std::size_t>();
    if (by >= result.suppressions.size()) throw UnknownShape("a finding names a suppression that is not there");
    result.suppressed.push_back({read_finding(finding), by});
  }
}

Report report_of(const Json& json) {
  if (const auto& version = json.at("schemaVersion").get_ref<const std::string&>(); !is_readable(version)) {
    throw UnknownShape("its schemaVersion is " + version + ", this version reads " + std::string(kOldestSchema) +
                       " to " + std::string(kSchemaVersion));
  }
  Report report;
  report.tool = json.at("tool").at("name").get<std::string>();
  report.max_issues = 0;
  read_invocation(json.at("invocation"), report);
  const Json& checked = json.at("summary").at("checkedRules");
  for (const Json& entry : json.at("inputs")) {
    InputReport& input = report.inputs.emplace_back(read_input(entry));
    input.result.checked = read_checked(checked, entry.at("unchecked"));
    for (const Json& rest : entry.at("unlisted")) input.unlisted.push_back(read_unlisted(rest));
  }
  for (const Json& entry : json.at("findings")) {
    report.inputs.at(entry.at("input").get<std::size_t>()).result.findings.push_back(read_finding(entry));
  }
  read_suppressed(json, report);
  if (!report.inputs.empty()) {
    for (const auto& [step, seconds] : json.at("timings").items()) {
      report.inputs.front().result.timings.emplace_back(step, seconds.get<double>());
    }
  }
  return report;
}

// Lines of JSON where the text as a whole is none.
std::vector<Json> documents_in(std::string_view text) {
  std::vector<Json> documents;
  if (Json whole = Json::parse(text, nullptr, false); !whole.is_discarded()) return {std::move(whole)};
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.empty()) documents.push_back(Json::parse(line));
  }
  return documents;
}

}  // namespace

ReadBack read_report(std::string_view text) {
  try {
    std::vector<Report> parts;
    for (const Json& document : documents_in(text)) parts.push_back(report_of(document));
    if (parts.empty()) return {{}, "it is empty"};
    if (parts.size() == 1) return {std::move(parts.front()), {}};
    Joined joined = join_lines(std::move(parts));
    return {std::move(joined.report), std::move(joined.problem)};
  } catch (const UnknownShape& fault) {
    return {{}, fault.what()};
  } catch (const Json::exception&) {
    return {{}, "it is no JSON report of radlint"};
  } catch (const std::out_of_range&) {
    return {{}, "a finding names an input that is not there"};
  }
}

}  // namespace rad::report
