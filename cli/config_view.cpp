#include "cli/config_view.h"

#include <fmt/format.h>

#include "report/units.h"

namespace rad::cli {

namespace {

template <typename T, typename Text>
SettingView view_of(const std::string& name, const std::optional<config::Stated<T>>& stated, Text text) {
  if (!stated) return {name, {}, config::Origin{}.text()};
  return {name, text(stated->value), stated->origin.text()};
}

std::string text_of(const geom::ToleranceRequest& request) {
  using Measure = geom::ToleranceRequest::Measure;
  switch (request.measure) {
    case Measure::FileUnits:
      return fmt::format("{}", request.value);
    case Measure::Metres:
      return fmt::format("{}m", request.value);
    case Measure::Diagonals:
      return fmt::format("{}d", request.value);
    case Measure::Auto:
      break;
  }
  return "auto";
}

}  // namespace

ConfigView config_view(RunSettings& settings, const LintCommand& command, const std::string& path) {
  ConfigView view;
  view.path = path;
  view.chain = settings.chain_of(path);
  view.in_force = settings.in_force(path);
  const config::InForce& it = view.in_force;
  const auto stage = settings.stage_of(path);
  const auto fail_on = settings.fail_on_of(path);
  view.settings = {
      {"stage", std::string(validate::name(stage.value)), stage.origin.text()},
      {"fail-on", std::string(report::name(fail_on.value)), fail_on.origin.text()},
      view_of("units", it.metres_per_unit, report::unit_name),
      view_of("up", it.up, [](scene::UpAxis up) { return std::string(report::name(up)); }),
      view_of("tolerance", it.tolerance, text_of),
      view_of("lod", it.level_of_detail, [](double level) { return fmt::format("{}", level); }),
  };
  for (const auto& file : view.chain) {
    view.files.push_back(file->shown);
    for (const auto& pattern : file->exclude) {
      view.exclude.push_back({"exclude", pattern.value.glob, pattern.origin.text()});
    }
  }
  for (const std::string& glob : command.exclude) view.exclude.push_back({"exclude", glob, "--exclude"});
  return view;
}

}  // namespace rad::cli
