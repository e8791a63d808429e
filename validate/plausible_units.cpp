#include "validate/plausible_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rad::validate {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};

constexpr std::array<Unit, 5> kUnits{{{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}};

// Rooms and houses: a diagonal of 12 m, two thirds of them within a factor of 5.
constexpr double kUsualDiagonal = 12, kDiagonalSpread = 5;
// Parts of a model: half a metre, two thirds of them within a factor of 6.
constexpr double kUsualPart = 0.5, kPartSpread = 6;
constexpr std::string_view kParts = "parts";
// The median of fewer says little.
constexpr std::size_t kTellingParts = 10;

/// Things whose size is much the same everywhere: the diagonal of their largest part, in metres.
struct Kind {
  std::string_view word;  ///< in the name of the object, lower case
  std::string_view plural;
  double metres;
  double spread;
};

constexpr std::array<Kind, 5> kKinds{{
    {"door", "doors", 2.3, 1.3},
    {"chair", "chairs", 1.0, 1.5},
    {"bed", "beds", 2.4, 1.4},
    {"table", "tables", 1.6, 1.6},
    {"window", "windows", 1.8, 1.8},
}};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
char lower(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }
// Bytes beyond ASCII are parts of letters.
bool is_letter(char c) { return (lower(c) >= 'a' && lower(c) <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

bool ends_word(std::string_view text, std::size_t at) {
  return at >= text.size() || !is_letter(text[at]) || is_upper(text[at]);
}

// As a word of its own, also in the plural or in camel case: "Door_01", "doors", "FrontDoor", but not "outdoor".
bool has_word(std::string_view name, std::string_view word) {
  for (std::size_t at = 0; at + word.size() <= name.size(); ++at) {
    const std::string_view here = name.substr(at, word.size());
    if (!std::ranges::equal(here, word, {}, lower)) continue;
    const bool starts = at == 0 || !is_letter(name[at - 1]) || (is_upper(name[at]) && !is_upper(name[at - 1]));
    const std::size_t end = at + word.size();
    const bool plural = end < name.size() && name[end] == 's' && ends_word(name, end + 1);
    if (starts && (plural || ends_word(name, end))) return true;
  }
  return false;
}

double diagonal_of(const Context& context, const Component& component) {
  const geom::LatticePoint &a = component.low, &b = component.high;
  return context.length(std::hypot(double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z));
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// Per object the diagonal of its largest component; 0 for an object without one.
std::vector<double> largest_parts(const Context& context) {
  std::vector<double> largest(context.scene.objects.size(), 0);
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    const std::uint32_t component = context.topology.component_of_face[id];
    if (component == kNoComponent) continue;
    double& size = largest[context.object_of(id)];
    size = std::max(size, diagonal_of(context, context.topology.components[component]));
  }
  return largest;
}

bool find_kind(const Context& context, SizeEvidence& evidence) {
  const std::vector<std::string>& names = context.scene.objects;
  std::vector<double> largest;
  for (const Kind& kind : kKinds) {
    std::vector<double> sizes;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!has_word(names[i], kind.word)) continue;
      if (largest.empty()) largest = largest_parts(context);
      if (largest[i] > 0) sizes.push_back(largest[i]);
    }
    if (sizes.empty()) continue;
    evidence = {evidence.diagonal, median(sizes), kind.plural, kind.metres, kind.spread};
    return true;
  }
  return false;
}

double squared_deviation(double value, double usual, double spread) {
  const double steps = std::log(value / usual) / std::log(spread);
  return steps * steps;
}

}  // namespace

SizeEvidence size_evidence(const Context& context) {
  SizeEvidence evidence;
  evidence.diagonal = context.tolerance.diagonal;
  if (find_kind(context, evidence)) return evidence;
  std::vector<double> sizes;
  for (const Component& component : context.topology.components) {
    const double size = diagonal_of(context, component);
    if (size > 0) sizes.push_back(size);
  }
  if (sizes.size() >= kTellingParts) evidence = {evidence.diagonal, median(sizes), kParts, kUsualPart, kPartSpread};
  return evidence;
}

bool is_contradicted(const SizeEvidence& evidence, double metres) {
  constexpr double kSpreads = 4;
  if (evidence.typical == 0 || evidence.typical_name == kParts) return false;
  return squared_deviation(evidence.typical * metres, evidence.usual_metres, evidence.spread) > kSpreads * kSpreads;
}

double surprise_at(const SizeEvidence& evidence, double metres) {
  double surprise = squared_deviation(evidence.diagonal * metres, kUsualDiagonal, kDiagonalSpread);
  if (evidence.typical > 0) {
    surprise += squared_deviation(evidence.typical * metres, evidence.usual_metres, evidence.spread);
  }
  return surprise;
}

UnitGuesses plausible_units(const SizeEvidence& evidence) {
  std::vector<UnitGuess> guesses;
  for (const Unit& unit : kUnits) guesses.push_back({unit.name, unit.metres, surprise_at(evidence, unit.metres)});
  std::ranges::stable_sort(guesses, {}, &UnitGuess::surprise);
  return {guesses[0], guesses[1]};
}

std::string metric_length(double metres) {
  if (metres >= 1000) return fmt::format("{:.2g} km", metres / 1000);
  if (metres >= 100) return fmt::format("{:.0f} m", metres);
  if (metres >= 1) return fmt::format("{:.2g} m", metres);
  if (metres >= 0.01) return fmt::format("{:.2g} cm", metres * 100);
  return fmt::format("{:.2g} mm", metres * 1000);
}

std::string words_of(const SizeEvidence& evidence, const UnitGuesses& guesses) {
  const bool by_kind = evidence.typical > 0 && evidence.typical_name != kParts;
  const double size = by_kind ? evidence.typical : evidence.diagonal;
  const std::string_view what = by_kind ? evidence.typical_name : "the model";
  return fmt::format("{} would be {}{} if units were {}; runner-up: {} ({})", what,
                     metric_length(size * guesses.best.metres), by_kind ? "" : " across", guesses.best.unit,
                     guesses.runner_up.unit, metric_length(size * guesses.runner_up.metres));
}

}  // namespace rad::validate
