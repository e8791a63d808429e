#include "report/sarif.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "report/json_parts.h"
#include "report/place_text.h"
#include "report/printable.h"
#include "report/sarif_rules.h"
#include "report/text.h"
#include "report/text_layout.h"
#include "validate/registry.h"
#include "validate/rules.h"

namespace rad::report {

namespace {

constexpr std::string_view kSchema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";
constexpr std::string_view kRootId = "%SRCROOT%";

// Percent-encoded but for what a path of a URI may hold (RFC 3986, 3.3), the colon excepted: it could end a scheme.
std::string uri_path(std::string_view path) {
  std::string out;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/!$&'()*+,;=@").find(c) != std::string_view::npos;
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

Json artifact_location(std::string_view path, const WriteOptions& options) {
  const std::string relative = relative_path(path, options.root);
  Json json;
  if (relative.starts_with('/')) {
    json["uri"] = "file://" + uri_path(relative);
  } else {
    json["uri"] = uri_path(relative);
    json["uriBaseId"] = kRootId;
  }
  return json;
}

// Only the first line and character of a file without lines: a place is asked for, and there is none.
Json region(std::uint64_t line) {
  const std::uint64_t start = std::max<std::uint64_t>(line, 1);
  Json json;
  json["startLine"] = start;
  json["startColumn"] = 1;
  json["endLine"] = start;
  json["endColumn"] = 2;
  return json;
}

Json physical_location(std::string_view path, std::uint64_t line, const WriteOptions& options) {
  Json json;
  json["artifactLocation"] = artifact_location(path, options);
  json["region"] = region(line);
  return json;
}

Json logical_locations(const scene::Where& where) {
  Json json = Json::array();
  if (!where.pointer.empty()) json.push_back({{"fullyQualifiedName", printable(where.pointer)}, {"kind", "object"}});
  for (const std::string& object : where.objects) {
    if (object.empty()) continue;
    json.push_back({{"name", printable(object)}, {"fullyQualifiedName", printable(object)}, {"kind", "element"}});
  }
  return json;
}

Json location(const scene::Finding& finding, const WriteOptions& options) {
  Json json;
  json["physicalLocation"] = physical_location(finding.where.file, finding.where.line, options);
  if (Json logical = logical_locations(finding.where); !logical.empty()) json["logicalLocations"] = std::move(logical);
  return json;
}

// The faces that take part besides the one where the fault is, as far as they have lines.
Json related_locations(const scene::Finding& finding, const WriteOptions& options) {
  Json json = Json::array();
  for (const scene::FaceReference& face : finding.where.faces) {
    if (face.line == 0 || face.line == finding.where.line) continue;
    Json related;
    related["id"] = json.size() + 1;
    related["physicalLocation"] = physical_location(finding.where.file, face.line, options);
    related["message"]["text"] = "face that takes part";
    json.push_back(std::move(related));
  }
  return json;
}

// Brackets of names must not make a link (SARIF 2.1.0, 3.11.6).
std::string message_text(const scene::Finding& finding, bool links) {
  std::string text = printable(finding.message);
  if (text.find("](") != std::string::npos) text = with_backslashes(text, "[]");
  if (text.empty()) text = finding.alias;
  return links ? text + " ([other face](1))" : text;
}

Json properties(const scene::Finding& finding, const InputReport& input) {
  Json json;
  json["alias"] = finding.alias;
  json["requirement"] = finding.requirement;
  json["kind"] = scene::name(finding.kind);
  json["places"] = finding.count;
  if (finding.where.point) {
    json["point"] = point_json(*finding.where.point);
    json["unit"] = input.metres_per_unit ? number(*input.metres_per_unit) : Json(nullptr);
  }
  if (finding.measure) {
    json["measure"]["name"] = finding.measure->name;
    json["measure"]["value"] = number(finding.measure->value);
    json["measure"]["threshold"] = finding.measure->threshold ? number(*finding.measure->threshold) : Json(nullptr);
    json["measure"]["unit"] = finding.measure->unit;
  }
  for (const std::string& material : finding.where.materials) json["materials"].push_back(printable(material));
  if (finding.where.byte_offset) json["byteOffset"] = *finding.where.byte_offset;
  if (const std::string fix = fix_text(finding.fix); !fix.empty()) json["fix"] = fix;
  return json;
}

std::size_t rule_index(std::string_view id) {
  const auto rules = validate::all_rules();
  return static_cast<std::size_t>(
      std::ranges::find_if(rules, [&](const validate::Rule* rule) { return rule->id == id; }) - rules.begin());
}

Json result_head(std::string_view rule, scene::Severity severity) {
  Json json;
  json["ruleId"] = rule;
  if (const std::size_t index = rule_index(rule); index < validate::all_rules().size()) json["ruleIndex"] = index;
  json["level"] = scene::name(severity);
  return json;
}

Json fingerprints(const std::string& fingerprint) {
  return {{"primaryLocationLineHash", fingerprint + ":1"}, {"radlint/v1", fingerprint}};
}

std::string_view baseline_state(scene::BaselineState state) {
  switch (state) {
    case scene::BaselineState::None:
      break;
    case scene::BaselineState::New:
      return "new";
    case scene::BaselineState::Grown:
      return "updated";
    case scene::BaselineState::Known:
      return "unchanged";
  }
  return {};
}

Json suppression_json(const validate::SuppressionUse& use, const WriteOptions& options) {
  Json json;
  json["kind"] = use.origin == scene::WaiverOrigin::Model ? "inSource" : "external";
  json["status"] = "accepted";
  if (!use.reason.empty()) json["justification"] = printable(use.reason);
  json["location"]["physicalLocation"] = physical_location(use.place.file, use.place.line, options);
  return json;
}

Json result(const scene::Finding& finding, const InputReport& input, const WriteOptions& options) {
  Json related = related_locations(finding, options);
  Json json = result_head(finding.rule, finding.severity);
  json["message"]["text"] = message_text(finding, !related.empty());
  json["locations"] = Json::array({location(finding, options)});
  if (!related.empty()) json["relatedLocations"] = std::move(related);
  json["partialFingerprints"] = fingerprints(finding.fingerprint);
  if (const std::string_view state = baseline_state(finding.baseline); !state.empty()) json["baselineState"] = state;
  json["properties"] = properties(finding, input);
  return json;
}

struct Candidate {
  const scene::Finding* finding = nullptr;
  const InputReport* input = nullptr;
  std::size_t nth = 0;  ///< of its rule and input
  const validate::SuppressionUse* suppression = nullptr;
};

/// What of a rule has no result of its own.
struct Rest {
  const Candidate* first = nullptr;
  std::uint64_t findings = 0;
};

// What is suppressed comes last, before it what a baseline knows. By severity; among equals the worst of every rule and
// input come first, so that each of them is seen.
std::vector<Candidate> candidates(const Report& report) {
  std::vector<Candidate> all;
  for (const InputReport& input : report.inputs) {
    std::map<std::string_view, std::size_t> seen;
    for (const auto* findings : {&input.result.findings, &input.known}) {
      for (const scene::Finding& finding : *findings) all.push_back({&finding, &input, seen[finding.rule]++});
    }
    for (const validate::SuppressedFinding& silenced : input.result.suppressed) {
      const scene::Finding& finding = silenced.finding;
      all.push_back({&finding, &input, seen[finding.rule]++, &input.result.suppressions[silenced.by]});
    }
  }
  const auto key = [](const Candidate& candidate) {
    const bool known = candidate.finding->baseline == scene::BaselineState::Known;
    return std::tuple(candidate.suppression != nullptr, known, -static_cast<int>(candidate.finding->severity),
                      candidate.nth);
  };
  std::ranges::stable_sort(all, [&](const Candidate& x, const Candidate& y) { return key(x) < key(y); });
  return all;
}

Json roll_up(std::string_view rule, const Rest& rest, const WriteOptions& options) {
  const scene::Finding& first = *rest.first->finding;
  Json json = result_head(rule, first.severity);
  json["message"]["text"] =
      fmt::format("{} of {} that are not listed one by one", counted(rest.findings, "more finding"), first.alias);
  Json place;
  place["physicalLocation"] = physical_location(first.where.file, 1, options);
  json["locations"] = Json::array({std::move(place)});
  json["partialFingerprints"] = fingerprints(fmt::format("{}-rest", rule));
  return json;
}

class Run {
 public:
  Run(const Report& report, const WriteOptions& options, std::size_t limit)
      : report_(report), options_(options), limit_(limit), suppresses_(suppressed_findings(report) > 0) {}

  Json json() {
    add_results();
    Json run;
    run["tool"]["driver"] = driver();
    run["automationDetails"]["id"] = fmt::format("{}/{}/", report_.tool, validate::name(report_.stage));
    run["columnKind"] = "utf16CodeUnits";
    run["originalUriBaseIds"][std::string(kRootId)]["description"]["text"] = "the folder that paths are relative to";
    run["invocations"] = Json::array({invocation()});
    run["artifacts"] = artifacts();
    run["results"] = std::move(results_);
    return run;
  }

 private:
  void add_results() {
    const std::vector<Candidate> all = candidates(report_);
    const std::size_t rules = rule_totals(report_).size();
    const std::size_t single = all.size() <= limit_ ? all.size() : limit_ - std::min(rules, limit_);
    std::map<std::string_view, Rest> rests;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i < single) {
        Json& json = results_.emplace_back(result(*all[i].finding, *all[i].input, options_));
        // Where one result has the property all should (SARIF 2.1.0, 3.27.23).
        if (suppresses_) json["suppressions"] = Json::array();
        if (all[i].suppression) json["suppressions"].push_back(suppression_json(*all[i].suppression, options_));
        continue;
      }
      if (all[i].suppression) continue;
      Rest& rest = rests[all[i].finding->rule];
      if (rest.findings++ == 0) rest.first = &all[i];
    }
    for (const auto& [rule, rest] : rests) {
      results_.push_back(roll_up(rule, rest, options_));
      if (suppresses_) results_.back()["suppressions"] = Json::array();
    }
    left_out_ = all.size() - single;
  }

  [[nodiscard]] Json driver() const {
    Json json;
    json["name"] = report_.tool;
    json["version"] = tool_version();
    json["semanticVersion"] = tool_version();
    json["rules"] = sarif_rules_json(report_.stage);
    return json;
  }

  [[nodiscard]] Json invocation() const {
    Json json;
    json["executionSuccessful"] = true;
    Json notes = Json::array();
    if (left_out_ > 0) {
      Json note =
          notification(fmt::format("{} not listed one by one", counted(left_out_, "finding is", "findings are")));
      note["associatedRule"] = {{"id", validate::truncated.id}, {"index", rule_index(validate::truncated.id)}};
      notes.push_back(std::move(note));
    }
    for (const InputReport& input : report_.inputs) {
      if (input.result.incomplete.empty()) continue;
      notes.push_back(notification(printable(input.path + ": " + input.result.incomplete)));
    }
    if (!notes.empty()) json["toolExecutionNotifications"] = std::move(notes);
    return json;
  }

  static Json notification(const std::string& text) {
    Json json;
    json["level"] = "warning";
    json["message"]["text"] = text;
    return json;
  }

  [[nodiscard]] Json artifacts() const {
    Json json = Json::array();
    for (const InputReport& input : report_.inputs) {
      Json artifact;
      artifact["location"] = artifact_location(input.path, options_);
      artifact["length"] = input.bytes;
      artifact["roles"] = Json::array({"analysisTarget"});
      json.push_back(std::move(artifact));
    }
    return json;
  }

  const Report& report_;
  const WriteOptions& options_;
  std::size_t limit_;
  bool suppresses_;
  std::size_t left_out_ = 0;
  Json results_ = Json::array();
};

}  // namespace

std::string sarif(const Report& report, const WriteOptions& options, std::size_t limit) {
  Json json;
  json["$schema"] = kSchema;
  json["version"] = "2.1.0";
  json["runs"] = Json::array({Run(report, options, limit).json()});
  return written(json);
}

std::string sarif(const Report& report, const WriteOptions& options) { return sarif(report, options, kSarifResults); }

}  // namespace rad::report
