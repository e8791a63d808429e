#include "validate/waivers.h"

#include <fmt/format.h>

#include <algorithm>

#include "validate/registry.h"
#include "validate/rules.h"
#include "validate/tool_finding.h"

namespace rad::validate {

namespace {

bool is_about_the_run(const std::vector<const Rule*>& rules) { return std::ranges::all_of(rules, &Rule::of_tool); }

std::string unknown_rule_text(std::string_view selector) {
  return fmt::format("a suppression names '{}', which is no rule; did you mean {}?", selector,
                     nearest_selector(selector));
}

std::string unused_text(std::string_view selector, const std::vector<const Rule*>& rules) {
  if (is_about_the_run(rules)) {
    return fmt::format("{} is about the run, which no suppression of a model reaches: ignore it in radlint.toml",
                       selector);
  }
  return fmt::format("the suppression of {} suppresses nothing", selector);
}

}  // namespace

Waivers::Waivers(std::span<const scene::Waiver> waivers, const scene::Scene& scene)
    : waivers_(waivers), scene_(scene), named_(waivers.size()) {
  for (std::size_t i = 0; i < waivers.size(); ++i) {
    if (waivers[i].scope == scene::WaiverScope::Names) named_[i].emplace(waivers[i].names, scene);
    if (!waivers[i].fault.empty()) continue;
    for (const std::string& selector : waivers[i].rules) entries_.push_back({i, selector, matching_rules(selector)});
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    for (const Rule* rule : entries_[i].rules) {
      if (!rule->of_tool) of_rule_[rule].push_back(i);
    }
  }
}

bool Waivers::covers_face(std::size_t waiver, scene::FaceId face) const {
  return named_[waiver] ? named_[waiver]->has(scene_.faces[face]) : scene::covers(waivers_[waiver], scene_, face);
}

bool Waivers::covers_violation(std::size_t waiver, const Violation& violation) const {
  const auto& faces = violation.faces;
  if (std::ranges::any_of(faces, [&](FaceId face) { return face != kNoFace && covers_face(waiver, face); }))
    return true;
  if (faces[0] != kNoFace) return false;
  if (waivers_[waiver].scope == scene::WaiverScope::File) return true;
  if (violation.vertex == kNoVertex || scene_.vertex_records.size() != scene_.vertices.size()) return false;
  return scene::covers_record(waivers_[waiver], {scene_.vertex_section, scene_.vertex_records[violation.vertex]});
}

bool Waivers::covers_issue(std::size_t waiver, const scene::ReadIssue& issue) const {
  const scene::Waiver& it = waivers_[waiver];
  if (it.scope == scene::WaiverScope::File) return true;
  if (issue.place.line == 0 || it.section >= scene_.sections.size()) return false;
  const bool same_file = issue.place.file.empty() || issue.place.file == scene_.sections[it.section].file;
  return same_file && scene::covers_record(it, {it.section, issue.place.line});
}

template <typename Covers>
std::optional<std::size_t> Waivers::first_of(const Rule& rule, Covers covers) {
  const auto found = of_rule_.find(&rule);
  if (found == of_rule_.end()) return std::nullopt;
  for (const std::size_t entry : found->second) {
    if (!covers(entries_[entry].waiver)) continue;
    entries_[entry].used = true;
    return entries_[entry].waiver;
  }
  return std::nullopt;
}

std::optional<std::size_t> Waivers::silencing(const Rule& rule, const Violation& violation) {
  return first_of(rule, [&](std::size_t waiver) { return covers_violation(waiver, violation); });
}

std::optional<std::size_t> Waivers::silencing(const Rule& rule, const scene::ReadIssue& issue) {
  return first_of(rule, [&](std::size_t waiver) { return covers_issue(waiver, issue); });
}

scene::Where Waivers::place_of(const scene::Waiver& waiver) const {
  scene::Where where;
  where.file = waiver.place.file.empty() ? scene_.path : waiver.place.file;
  where.line = waiver.place.line;
  where.byte_offset = waiver.place.byte_offset;
  where.pointer = waiver.place.pointer;
  return where;
}

SuppressionUse Waivers::use_of(std::size_t index) const {
  const scene::Waiver& waiver = waivers_[index];
  SuppressionUse use{waiver.origin, waiver.rules, waiver.reason, waiver.place};
  if (use.place.file.empty()) use.place.file = scene_.path;
  return use;
}

std::vector<scene::Finding> Waivers::complaints(const LintOptions& options, std::span<const Rule* const> checked,
                                                bool all_judged) const {
  std::vector<scene::Finding> findings;
  const auto add = [&](const Rule& rule, const std::string& what, const scene::Waiver& waiver) {
    if (std::ranges::find(options.rules, &rule) == options.rules.end()) return;
    findings.push_back(tool_finding(rule, what, place_of(waiver)));
    findings.back().severity = severity_of_tool_rule(rule, options);
  };
  const auto was_checked = [&](const Rule* rule) {
    return rule->of_tool || std::ranges::find(checked, rule) != checked.end();
  };
  for (const scene::Waiver& waiver : waivers_) {
    if (!waiver.fault.empty()) add(unknown_rule, "a suppression cannot be understood: " + waiver.fault, waiver);
  }
  for (const Entry& entry : entries_) {
    const scene::Waiver& waiver = waivers_[entry.waiver];
    if (entry.rules.empty()) {
      add(unknown_rule, unknown_rule_text(entry.selector), waiver);
    } else if (waiver.origin != scene::WaiverOrigin::Configuration && !entry.used && all_judged &&
               std::ranges::all_of(entry.rules, was_checked)) {
      add(unused_suppression, unused_text(entry.selector, entry.rules), waiver);
    }
  }
  return findings;
}

}  // namespace rad::validate
