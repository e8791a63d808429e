#include "report/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rad::report {

namespace {

std::string disagreement(const Report& first, const Report& other) {
  if (first.tool != other.tool) return "reports of radlint and radfix are not one run";
  if (first.stage != other.stage) {
    return fmt::format("they were judged at different stages, {} and {}", validate::name(first.stage),
                       validate::name(other.stage));
  }
  if (first.fail_on != other.fail_on) {
    return fmt::format("they were made with different --fail-on, {} and {}", name(first.fail_on), name(other.fail_on));
  }
  if (first.select != other.select || first.ignore != other.ignore) {
    return "they were made with different --select or --ignore";
  }
  if (first.shard.has_value() != other.shard.has_value()) return "some are shards of a run and others are not";
  if (first.shard && (first.shard->count != other.shard->count || first.shard->files != other.shard->files)) {
    return "they are shards of different runs";
  }
  return {};
}

std::string missing_shards(const std::vector<Report>& reports) {
  std::vector<bool> there(reports.front().shard->count, false);
  for (const Report& report : reports) {
    const std::size_t index = report.shard->index;
    if (index < 1 || index > there.size()) return fmt::format("shard {} of {} cannot be", index, there.size());
    there[index - 1] = true;
  }
  std::string missing;
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (!there[i]) missing += fmt::format("{}{}/{}", missing.empty() ? "" : ", ", i + 1, there.size());
  }
  return missing.empty() ? missing : "not all shards are here: " + missing + " missing";
}

std::string repeated_input(const std::vector<InputReport>& inputs) {
  std::vector<std::string_view> paths;
  for (const InputReport& input : inputs) paths.push_back(input.path);
  std::ranges::sort(paths);
  const auto twice = std::ranges::adjacent_find(paths);
  return twice == paths.end() ? std::string() : fmt::format("{} is in more than one of them", *twice);
}

// Inputs of all shards at their positions in the whole run.
std::string put_in_order(std::vector<Report>& reports, std::vector<InputReport>& inputs) {
  std::map<std::size_t, InputReport> at;
  for (Report& report : reports) {
    if (report.shard->positions.size() != report.inputs.size()) return "a shard does not say where its files belong";
    for (std::size_t i = 0; i < report.inputs.size(); ++i) {
      const std::size_t position = report.shard->positions[i];
      if (!at.emplace(position, std::move(report.inputs[i])).second) return "two shards hold the same file";
    }
  }
  const std::size_t files = reports.front().shard->files;
  if (at.size() != files || (files > 0 && at.rbegin()->first != files - 1)) {
    return fmt::format("{} of the {} files of the run are here", at.size(), files);
  }
  for (auto& [position, input] : at) inputs.push_back(std::move(input));
  return {};
}

std::string put_behind(std::vector<Report>& reports, std::vector<InputReport>& inputs) {
  for (Report& report : reports) std::ranges::move(report.inputs, std::back_inserter(inputs));
  return {};
}

}  // namespace

Joined join_lines(std::vector<Report> lines) {
  Joined joined;
  std::vector<InputReport> inputs;
  for (const Report& line : lines) {
    joined.problem = disagreement(lines.front(), line);
    if (!joined.problem.empty()) return joined;
  }
  std::optional<Shard> shard = lines.front().shard;
  if (shard) {
    shard->positions.clear();
    for (const Report& line : lines) std::ranges::copy(line.shard->positions, std::back_inserter(shard->positions));
  }
  put_behind(lines, inputs);
  joined.report = std::move(lines.front());
  joined.report.inputs = std::move(inputs);
  joined.report.shard = std::move(shard);
  return joined;
}

Joined merged(std::vector<Report> reports) {
  Joined joined;
  for (const Report& report : reports) {
    joined.problem = disagreement(reports.front(), report);
    if (!joined.problem.empty()) return joined;
  }
  const bool shards = reports.front().shard.has_value();
  if (shards) joined.problem = missing_shards(reports);
  if (!joined.problem.empty()) return joined;
  std::vector<InputReport> inputs;
  joined.problem = shards ? put_in_order(reports, inputs) : put_behind(reports, inputs);
  if (joined.problem.empty()) joined.problem = repeated_input(inputs);
  if (!joined.problem.empty()) return joined;
  joined.report = std::move(reports.front());
  joined.report.inputs = std::move(inputs);
  joined.report.shard.reset();
  return joined;
}

}  // namespace rad::report
