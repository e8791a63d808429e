// EULUMDAT: luminous intensities of a luminaire, a value a line. There is no surface in it.
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "readers/photometry.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"

namespace rad::readers {

extern const Reader ldt_reader;

namespace {

using scene::ReadIssueKind;

constexpr std::array<std::string_view, 1> kSuffixes = {".ldt"};
constexpr double kMetresPerMillimetre = 0.001;
constexpr std::size_t kRoomIndices = 10;
constexpr std::size_t kLinesOfLampSet = 6;
constexpr double kMostDifference = 0.05;
constexpr double kAngleAccuracy = 0.01;
// "0" and a line end.
constexpr std::uint64_t kLeastLineBytes = 2;

/// Kinds of symmetry, as files number them.
enum Symmetry : std::uint8_t { kNone, kRotation, kAboutC0, kAboutC90, kAboutBoth };

class LdtReader {
 public:
  explicit LdtReader(const Input& input)
      : input_(input),
        cursor_(input.bytes, input.limits.line_bytes),
        builder_(luminaire(input, "ldt", kMetresPerMillimetre)) {}

  ReadResult run() {
    if (read_figures() && read_lamps() && read_angles() && read_intensities()) judge();
    if (cursor_.passed_line_limit())
      fault("a line is longer than " + std::to_string(input_.limits.line_bytes) + " bytes");
    return {builder_.take(), std::move(issues_)};
  }

 private:
  bool read_figures() {
    if (!skip(2)) return false;
    const auto symmetry = count("the symmetry", 4);
    symmetry_line_ = cursor_.line();
    if (!symmetry) return false;
    const auto planes = count("the number of planes", room());
    const auto step = number("the angle between planes");
    const auto angles = count("the number of angles of a plane", room());
    if (!planes || !step || !angles || !number("the angle between intensities") || !skip(15)) return false;
    const auto light_ratio = number("the light output ratio"), factor = number("the factor of intensities");
    if (!light_ratio || !factor || !skip(1)) return false;
    if (*planes < 1 || *angles < 2) return fault("a luminaire has one plane and two angles at least");
    symmetry_ = static_cast<Symmetry>(*symmetry);
    planes_ = *planes;
    step_ = *step;
    angles_ = *angles;
    light_ratio_ = *light_ratio;
    return true;
  }

  bool read_lamps() {
    const auto sets = count("the number of sets of lamps", room());
    if (!sets) return false;
    for (std::size_t set = 0; set < *sets; ++set) {
      const auto lamps = number("the number of lamps");
      // A negative number says that intensities are not per lumen of the lamps.
      absolute_ = absolute_ || (lamps && *lamps < 0);
      if (!lamps || !skip(kLinesOfLampSet - 1)) return false;
    }
    return skip(kRoomIndices);
  }

  bool read_angles() {
    if (planes_ > room() || angles_ > room()) return fault("more angles are announced than the file has room for");
    angles_line_ = cursor_.line() + 1;
    if (!read_list(planes_, "the angle of a plane", photometry_.horizontal)) return false;
    if (!read_list(angles_, "an angle of intensities", photometry_.vertical)) return false;
    if (!are_ascending(photometry_.horizontal) || !are_ascending(photometry_.vertical)) {
      return fault("angles do not ascend");
    }
    return true;
  }

  // What follows has to be what the symmetry leaves of the planes.
  bool read_intensities() {
    const auto [first, listed] = listed_planes();
    if (listed == 0) return false;
    std::vector<double> all;
    while (cursor_.next_line()) {
      const std::string text = value_text();
      if (text.empty()) continue;
      const auto value = parse_number(text);
      if (!value || !is_believable(*value) || *value < 0) return fault(in_quotes(text) + " is no intensity");
      all.push_back(*value);
    }
    if (all.size() != listed * angles_) {
      return asymmetric(std::to_string(all.size()) + " intensities follow, " + std::to_string(listed) + " planes of " +
                        std::to_string(angles_) + " have " + std::to_string(listed * angles_));
    }
    const auto begin = photometry_.horizontal.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<double> kept(begin,
                             std::min(begin + static_cast<std::ptrdiff_t>(listed), photometry_.horizontal.end()));
    if (symmetry_ == kNone && listed > 1) close_the_turn(all, kept);
    photometry_.horizontal = std::move(kept);
    photometry_.intensity = std::move(all);
    return true;
  }

  // The last plane is the first again.
  void close_the_turn(std::vector<double>& all, std::vector<double>& planes) const {
    planes.push_back(planes.front() + 360);
    all.insert(all.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(angles_));
  }

  /// The first plane that is listed, and how many are; none where the planes do not go with the symmetry.
  std::pair<std::size_t, std::size_t> listed_planes() {
    const bool whole_turn =
        step_ == 0 || planes_ == 1 || std::abs(static_cast<double>(planes_) * step_ - 360) <= kAngleAccuracy;
    if (!whole_turn) asymmetric("planes " + std::to_string(step_) + " degrees apart do not make a turn");
    const std::size_t parts = symmetry_ == kAboutBoth || symmetry_ == kAboutC90 ? 4 : symmetry_ == kAboutC0 ? 2 : 1;
    if (planes_ % parts != 0) {
      asymmetric(std::to_string(planes_) + " planes are not divided by its symmetry");
      return {0, 0};
    }
    switch (symmetry_) {
      case kNone:
        return {0, planes_};
      case kRotation:
        return {0, 1};
      case kAboutC0:
        return {0, planes_ / 2 + 1};
      case kAboutC90:
        return {3 * planes_ / 4, planes_ / 2 + 1};
      case kAboutBoth:
        break;
    }
    return {0, planes_ / 4 + 1};
  }

  void judge() {
    if (photometry_.vertical.front() > kAngleAccuracy || photometry_.vertical.back() < 90 - kAngleAccuracy) {
      issues_.add(
          issue_at_line(ReadIssueKind::PlaneGap, "intensities do not go from the nadir to the horizon", angles_line_));
    }
    // From the last plane of a turn to those before its middle the angles start again.
    std::vector<double>& turn = photometry_.horizontal;
    if (symmetry_ == kAboutC90) unwind(turn);
    if (absolute_ || light_ratio_ <= 0) return;
    const double share = flux_of(photometry_) / 10;  // lm per 1000 lm as a percentage
    if (std::abs(share - light_ratio_) <= kMostDifference * light_ratio_) return;
    issues_.add(issue_at_line(ReadIssueKind::FluxMismatch,
                              "intensities add up to " + std::to_string(std::lround(share)) +
                                  " % of the lamps' flux, the file states " +
                                  std::to_string(std::lround(light_ratio_)) + " %",
                              angles_line_));
  }

  // Half a turn from C270 on, over C0, to C90.
  void unwind(std::vector<double>& turn) const {
    const double step = 360.0 / static_cast<double>(planes_);
    const double first = turn.front();
    const std::size_t listed = planes_ / 2 + 1;
    turn.clear();
    for (std::size_t i = 0; i < listed; ++i) turn.push_back(first + static_cast<double>(i) * step);
  }

  [[nodiscard]] std::size_t room() const { return cursor_.bytes_left() / kLeastLineBytes + 1; }

  bool skip(std::size_t lines) {
    for (std::size_t i = 0; i < lines; ++i) {
      if (!cursor_.next_line()) return fault("the file ends early");
    }
    return true;
  }

  // Some write a comma for the point.
  std::string value_text() {
    std::string text(cursor_.rest());
    if (const std::size_t comma = text.find(','); comma != std::string::npos) text[comma] = '.';
    return text;
  }

  std::optional<double> number(const char* what) {
    if (!skip(1)) return std::nullopt;
    const std::string text = value_text();
    const auto value = parse_number(text);
    if (value && is_believable(*value)) return value;
    fault(in_quotes(text) + " is no number; it stands for " + what);
    return std::nullopt;
  }

  std::optional<std::size_t> count(const char* what, std::size_t most) {
    const auto value = number(what);
    if (!value) return std::nullopt;
    if (*value >= 0 && *value <= static_cast<double>(most) && std::floor(*value) == *value)
      return static_cast<std::size_t>(*value);
    fault(std::string("a number is out of range; it stands for ") + what);
    return std::nullopt;
  }

  bool read_list(std::size_t count, const char* what, std::vector<double>& into) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = number(what);
      if (!value) return false;
      into.push_back(*value);
    }
    return true;
  }

  bool fault(std::string what) {
    issues_.add(issue_at_line(ReadIssueKind::PhotometrySyntax, std::move(what), cursor_.line()));
    return false;
  }

  bool asymmetric(std::string what) {
    issues_.add(issue_at_line(ReadIssueKind::PhotometrySymmetry,
                              "symmetry " + std::to_string(static_cast<int>(symmetry_)) + ": " + std::move(what),
                              symmetry_line_));
    return false;
  }

  const Input& input_;
  TextCursor cursor_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  Photometry photometry_;
  Symmetry symmetry_ = kNone;
  std::size_t planes_ = 0, angles_ = 0;
  double step_ = 0;
  double light_ratio_ = 0;  ///< percent of the lamps' flux that leaves the luminaire
  bool absolute_ = false;
  std::uint64_t symmetry_line_ = 0, angles_line_ = 0;
};

bool sniff(std::string_view) { return false; }

ReadResult read(const Input& input) { return LdtReader(input).run(); }

}  // namespace

const Reader ldt_reader{"ldt", kSuffixes, sniff, read};

}  // namespace rad::readers
