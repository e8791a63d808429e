#include "cli/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "cli/filter_words.h"
#include "cli/fix_only.h"
#include "cli/nearest.h"
#include "cli/report_choice.h"
#include "config/in_force.h"
#include "config/words.h"
#include "report/units.h"

namespace rad::cli {

namespace {

using config::Choices;

template <typename Value>
std::string read_choice(std::string_view option, const std::string& word, Choices<Value> choices, Value& into) {
  if (word.empty()) return {};
  const std::string fault = config::choose<Value>(word, choices, into);
  return fault.empty() ? fault : fmt::format("{}: {}", option, fault);
}

template <typename Value>
std::string read_choice(std::string_view option, const std::string& word, Choices<Value> choices,
                        std::optional<Value>& into) {
  if (word.empty()) return {};
  return read_choice<Value>(option, word, choices, into.emplace());
}

constexpr std::array<std::pair<std::string_view, PageFormat>, 3> kPageFormats = {
    {{"text", PageFormat::Text}, {"json", PageFormat::Json}, {"markdown", PageFormat::Markdown}}};
constexpr std::array<std::pair<std::string_view, PageFormat>, 2> kConfigFormats = {
    {{"text", PageFormat::Text}, {"json", PageFormat::Json}}};
constexpr std::array<std::pair<std::string_view, mesh::PatchMethod>, 2> kPatchMethods = {
    {{"graded", mesh::PatchMethod::Graded}, {"grid", mesh::PatchMethod::Grid}}};
constexpr std::array<std::pair<std::string_view, DrawnMesh>, 2> kDrawnMeshes = {
    {{"patches", DrawnMesh::Patches}, {"elements", DrawnMesh::Elements}}};
constexpr std::array<std::pair<std::string_view, mesh::ShadowSearch>, 3> kShadowSearches = {
    {{"silhouette", mesh::ShadowSearch::Silhouettes},
     {"hemicube", mesh::ShadowSearch::Hemicube},
     {"none", mesh::ShadowSearch::None}}};
constexpr std::array<std::pair<std::string_view, BakeMode>, 3> kBakeModes = {
    {{"vertex", BakeMode::Vertex}, {"lightmap", BakeMode::LightMap}, {"emissive", BakeMode::Emissive}}};
constexpr std::array<std::pair<std::string_view, scene::DisplayCurve>, 3> kCurves = {
    {{"linear", scene::DisplayCurve::Linear},
     {"shoulder", scene::DisplayCurve::Shoulder},
     {"reinhard", scene::DisplayCurve::Reinhard}}};
constexpr std::array<std::pair<std::string_view, bake::StoredQuantity>, 2> kStoredQuantities = {
    {{"M", bake::StoredQuantity::Exitance}, {"E", bake::StoredQuantity::Irradiance}}};
constexpr std::array<std::pair<std::string_view, ColorChoice>, 3> kColors = {
    {{"auto", ColorChoice::Auto}, {"always", ColorChoice::Always}, {"never", ColorChoice::Never}}};

std::string read_count(std::string_view option, const std::string& word, std::size_t least, std::size_t& into) {
  if (word.empty()) return {};
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value < least) {
    return fmt::format("{}: '{}' is not a whole number of at least {}", option, word, least);
  }
  into = value;
  return {};
}

std::string read_tolerance(const std::string& word, std::optional<geom::ToleranceRequest>& into) {
  if (word.empty()) return {};
  into = geom::parse_tolerance(word);
  if (into) return {};
  return fmt::format("--tolerance: '{}' is not a length; write 0.5mm, 0.5 (file units), 1e-5d (box diagonals) or auto",
                     word);
}

std::string read_units(const std::string& word, std::optional<double>& into) {
  if (word.empty()) return {};
  into = report::metres_in(word);
  return into ? std::string() : fmt::format("--units: '{}' is none of m, cm, mm, in, ft", word);
}

template <typename File>
std::string read_reports(const std::vector<std::string>& words, std::vector<File>& into) {
  for (const std::string& word : words) {
    if (std::string fault = read_file_report(word, into.emplace_back()); !fault.empty()) return fault;
  }
  return {};
}

// A finite number above 0; an empty word stands for none.
std::string read_positive(std::string_view option, const std::string& word, std::optional<double>& into) {
  if (word.empty()) return {};
  double value = 0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || rest != word.data() + word.size() || !std::isfinite(value) || value <= 0) {
    return fmt::format("{}: '{}' is not a number above 0", option, word);
  }
  into = value;
  return {};
}

std::string read_memory(const std::string& word, std::optional<std::uint64_t>& into) {
  if (word.empty()) return {};
  std::uint64_t value = 0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const std::string_view unit = std::string_view(word).substr(static_cast<std::size_t>(rest - word.data()));
  constexpr std::array<std::pair<std::string_view, int>, 7> kUnits = {
      {{"", 0}, {"K", 10}, {"KiB", 10}, {"M", 20}, {"MiB", 20}, {"G", 30}, {"GiB", 30}}};
  const auto* found = std::ranges::find(kUnits, unit, [](const auto& entry) { return entry.first; });
  if (error != std::errc{} || found == kUnits.end() || value == 0 || value > (UINT64_MAX >> found->second)) {
    return fmt::format("--memory-limit: '{}' is not a size; write 512M, 4G or bytes", word);
  }
  into = value << found->second;
  return {};
}

std::string read_shard(const std::string& word, std::optional<ShardChoice>& into) {
  if (word.empty()) return {};
  into = parse_shard(word);
  return into ? std::string()
              : fmt::format("--shard: '{}' is not of the form i/n with i from 1 to n, such as 1/4", word);
}

/// Runs the readers in order until one finds fault.
template <typename... Readers>
std::string first_fault(Readers&&... readers) {
  std::string fault;
  static_cast<void>(((fault = readers(), fault.empty()) && ...));
  return fault;
}

}  // namespace

std::string read_model_words(const ModelWords& words, ModelOptions& into) {
  into.reading.allow_commands = words.allow_commands;
  return first_fault([&] { return read_tolerance(words.tolerance, into.tolerance); },
                     [&] { return read_units(words.units, into.metres_per_unit); },
                     [&] { return read_choice<scene::UpAxis>("--up", words.up, config::kUpAxes, into.up); },
                     [&] { return read_count("--jobs", words.jobs, 1, into.jobs); },
                     [&] { return read_positive("--lod", words.level_of_detail, into.reading.level_of_detail); });
}

std::string read_lint_words(const LintWords& words, LintCommand& into) {
  std::size_t max_findings = 0;
  std::string fault = first_fault(
      [&] { return read_reports(words.reports, into.reports); },
      [&] { return read_format("--format", words.format, into.format); },
      [&] { return read_choice<validate::Stage>("--stage", words.stage, config::kStages, into.stage); },
      [&] { return read_choice<report::FailOn>("--fail-on", words.fail_on, config::kFailOn, into.fail_on); },
      [&] { return read_choice<ColorChoice>("--color", words.color, kColors, into.color); },
      [&] { return read_count("--max-issues", words.max_issues, 0, into.max_issues); },
      [&] { return read_count("--max-findings", words.max_findings, 0, max_findings); },
      [&] { return read_positive("--time-limit", words.time_limit, into.limits.seconds); },
      [&] { return read_memory(words.memory_limit, into.limits.bytes); },
      [&] { return read_shard(words.shard, into.shard); }, [&] { return read_model_words(words.model, into.model); });
  if (!words.max_findings.empty()) into.max_findings = max_findings;
  return fault;
}

std::string read_diff_words(const LintWords& words, DiffCommand& into) {
  LintWords of_models = words;
  of_models.format.clear();
  of_models.reports.clear();
  return first_fault([&] { return read_reports(words.reports, into.reports); },
                     [&] { return read_format("--format", words.format, into.format); },
                     [&] { return read_lint_words(of_models, into.lint); });
}

std::string read_rule_format(const std::string& word, PageFormat& into) {
  return read_choice<PageFormat>("--format", word, kPageFormats, into);
}

std::string read_config_format(const std::string& word, PageFormat& into) {
  return read_choice<PageFormat>("--format", word, kConfigFormats, into);
}

namespace {

std::string read_preview_mesh(const std::string& word, FixCommand& into) {
  std::string fault = read_choice<DrawnMesh>("--preview-mesh", word, kDrawnMeshes, into.drawn_mesh);
  if (!fault.empty() || into.drawn_mesh == DrawnMesh::None) return fault;
  if (into.preview.empty()) return "--preview-mesh: there is no picture; name one with --preview";
  return into.meshes() ? std::string() : "--preview-mesh: there is no mesh; ask for --mesh or --solve";
}

// "1,2,3" at the front of `word`, which loses it.
std::optional<geom::dvec3> taken_point(std::string_view& word) {
  geom::dvec3 point{0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0 && !word.starts_with(',')) return std::nullopt;
    if (axis > 0) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), point[axis]);
    if (error != std::errc() || !std::isfinite(point[axis])) return std::nullopt;
    word.remove_prefix(static_cast<std::size_t>(end - word.data()));
  }
  return point;
}

std::string read_camera(const std::string& text, FixCommand& into) {
  if (text.empty()) return {};
  if (into.preview.empty()) return "--camera: there is no picture; name one with --preview";
  std::string_view word = text;
  const auto from = taken_point(word);
  if (from && word.starts_with(':')) {
    word.remove_prefix(1);
    const auto to = taken_point(word);
    if (to && word.empty() && *to != *from) {
      into.camera = ViewLine{*from, *to};
      return {};
    }
  }
  return fmt::format("--camera: '{}' is not two places, as in 4,-3,1.6:0,0,1", text);
}

std::string read_page_size(const std::string& word, std::uint32_t& into) {
  std::size_t size = into;
  std::string fault = read_count("--page-size", word, bake::kLeastPageSize, size);
  if (!fault.empty()) return fault;
  if (size > bake::kMostPageSize)
    return fmt::format("--page-size: pages have at most {} texels a side", bake::kMostPageSize);
  into = static_cast<std::uint32_t>(size);
  return {};
}

std::string read_display(const FixWords& words, FixCommand& into) {
  std::string fault = read_choice<scene::DisplayCurve>("--curve", words.curve, kCurves, into.curve);
  if (!fault.empty()) return fault;
  if (words.false_colour && !words.curve.empty()) return "--falsecolor has a curve of its own; leave --curve out";
  if (words.false_colour) into.curve = scene::DisplayCurve::FalseColour;
  if (into.solves()) {
    const bool bends = into.curve != scene::DisplayCurve::Linear;
    return bends && into.bake == BakeMode::Emissive ? "--bake emissive is light and no picture: it has no curve" : "";
  }
  if (words.false_colour || !words.curve.empty()) return "--curve, --falsecolor: there is no light; ask for --solve";
  return into.viewer.empty() ? std::string() : "--viewer: there is no light; ask for --solve";
}

std::string read_bake(const FixWords& words, FixCommand& into) {
  std::string fault = first_fault(
      [&] { return read_choice<BakeMode>("--bake", words.bake, kBakeModes, into.bake); },
      [&] { return read_positive("--texel", words.texel, into.texel); },
      [&] { return read_page_size(words.page_size, into.page_size); },
      [&] { return read_choice<bake::StoredQuantity>("--store", words.store, kStoredQuantities, into.stored); });
  if (!fault.empty()) return fault;
  if (into.maps_light()) {
    return into.filters.has(scene::Filter::Bake) && into.solves() ? std::string()
                                                                  : "--bake: there is no light; ask for --solve";
  }
  for (const auto& [option, word] : {std::pair("--texel", &words.texel), std::pair("--page-size", &words.page_size),
                                     std::pair("--store", &words.store)}) {
    if (!word->empty()) return fmt::format("{}: there is no light map; ask for --bake lightmap or emissive", option);
  }
  return {};
}

// "GLOB=LENGTH"; a name may hold the sign too.
std::string read_patch_sizes(const std::vector<std::string>& words, std::vector<PatchSizeOf>& into) {
  for (const std::string& word : words) {
    const std::size_t sign = word.rfind('=');
    std::optional<double> length;
    if (sign == std::string::npos || sign == 0 || sign + 1 == word.size()) {
      return fmt::format("--patch-size-of: '{}' is not GLOB=LENGTH", word);
    }
    std::string fault = read_positive("--patch-size-of", word.substr(sign + 1), length);
    if (!fault.empty()) return fault;
    into.push_back({word.substr(0, sign), *length});
  }
  return {};
}

std::string read_coplanar_policy(const std::string& word, repair::CoplanarOptions& into) {
  if (word.empty()) return {};
  const auto policy = repair::parse_coplanar_policy(word);
  if (!policy) {
    return fmt::format("--coplanar-policy: '{}' is none of paper, area, priority, keep-first, keep-last", word);
  }
  into.policy = *policy;
  if (*policy != repair::CoplanarPolicy::Priority || !into.priority.empty()) return {};
  return "--coplanar-policy priority: say which with --priority";
}

std::string read_fix_only(const std::vector<std::string>& selectors, std::vector<const validate::Rule*>& into) {
  for (const std::string& selector : selectors) {
    const auto rules = validate::matching_rules(selector);
    if (rules.empty()) return "--fix-only: " + config::unknown_rule_text(selector);
    into.insert(into.end(), rules.begin(), rules.end());
  }
  return {};
}

// Without a name standard input and standard output are meant, but for what goes nowhere.
std::string read_places(FixCommand& into) {
  if (into.input.empty()) into.input = kStream;
  if (into.in_place) {
    if (!into.output.empty()) return "--in-place writes to the input; leave --output out";
    if (into.input == kStream) return "--in-place: standard input is no file";
    into.output = into.input;
  }
  if (!into.output.empty() || into.dry_run) return {};
  if (into.input != kStream) return "-o is missing: name the file to write, or ask for --dry-run or --in-place";
  into.output = kStream;
  return {};
}

}  // namespace

std::string read_fix_words(const FixWords& words, FixCommand& into) {
  return first_fault(
      [&] { return read_filters(words, into); }, [&] { return read_fix_only(words.fix_only, into.fix_only); },
      [&] { return choose_filters_for_rules(into); },
      [&] { return read_coplanar_policy(words.coplanar_policy, into.coplanar); },
      [&] { return read_positive("--patch-size", words.patch_size, into.patch_size); },
      [&] { return read_patch_sizes(words.patch_sizes, into.patch_sizes); },
      [&] { return read_choice<mesh::PatchMethod>("--pmesh", words.pmesh, kPatchMethods, into.patch_method); },
      [&] { return read_choice<mesh::ShadowSearch>("--emesh", words.emesh, kShadowSearches, into.shadow_search); },
      [&] { return read_positive("--element-size", words.element_size, into.element_size); },
      [&] { return read_preview_mesh(words.preview_mesh, into); }, [&] { return read_camera(words.camera, into); },
      [&] { return read_positive("--shadow-size", words.shadow_size, into.shadow_size); },
      [&] { return read_positive("--exposure", words.exposure, into.exposure); },
      [&] { return read_bake(words, into); }, [&] { return read_display(words, into); },
      [&] { return read_reports(words.reports, into.reports); }, [&] { return read_places(into); });
}

namespace {

using Words = std::optional<config::Stated<config::Words>>;

std::string read_selectors(const std::string& option, const std::vector<std::string>& selectors, Words& into) {
  for (const std::string& selector : selectors) {
    if (validate::matching_rules(selector).empty()) return config::unknown_rule_text(selector);
  }
  if (!selectors.empty()) into = {selectors, {option}};
  return {};
}

// "RL240=note"
std::string read_severities(const std::vector<std::string>& words, config::Settings& into) {
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos) return fmt::format("--severity: '{}' is not RULE=SEVERITY", word);
    config::RuleSeverity severity;
    std::string fault = config::choose<config::RuleSeverity>(word.substr(sign + 1), config::kSeverities, severity);
    if (!fault.empty()) return "--severity: " + fault;
    const auto rules = validate::matching_rules(word.substr(0, sign));
    if (rules.empty()) return "--severity: " + config::unknown_rule_text(word.substr(0, sign));
    for (const validate::Rule* rule : rules) into.rules[rule].severity = {severity, {"--severity"}};
  }
  return {};
}

void read_model_settings(const ModelOptions& model, config::Settings& into) {
  if (model.metres_per_unit) into.metres_per_unit = {*model.metres_per_unit, {"--units"}};
  if (model.up != scene::UpAxis::Unknown) into.up = {model.up, {"--up"}};
  if (model.tolerance) into.tolerance = {*model.tolerance, {"--tolerance"}};
  if (model.reading.level_of_detail) into.level_of_detail = {*model.reading.level_of_detail, {"--lod"}};
}

// Whatever the configuration says, it cannot bring rules back that the command line takes away.
std::string refuse_no_rules(const config::Settings& settings) {
  const config::InForce alone = config::in_force({}, {}, settings);
  const bool some = std::ranges::any_of(alone.rules, &config::RuleInForce::on);
  return some ? std::string() : "--select and --ignore leave no rule to check";
}

}  // namespace

std::string read_settings(LintCommand& command) {
  config::Settings& settings = command.settings;
  read_model_settings(command.model, settings);
  if (command.isolated && !command.config.empty()) return "--isolated heeds no configuration; leave --config out";
  return first_fault([&] { return read_selectors("--select", command.select, settings.select); },
                     [&] { return read_selectors("--ignore", command.ignore, settings.ignore); },
                     [&] { return read_selectors("--extend-select", command.extend_select, settings.extend_select); },
                     [&] { return read_selectors("--extend-ignore", command.extend_ignore, settings.extend_ignore); },
                     [&] { return read_severities(command.severities, settings); },
                     [&] { return refuse_no_rules(settings); });
}

}  // namespace rad::cli
