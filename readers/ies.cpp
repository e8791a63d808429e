// IES LM-63: luminous intensities of a luminaire. There is no surface in it; what cannot be believed is reported.
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "readers/photometry.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"

namespace rad::readers {

extern const Reader ies_reader;

namespace {

using scene::ReadIssueKind;

constexpr std::array<std::string_view, 1> kSuffixes = {".ies"};
constexpr double kMetresPerFoot = 0.3048;
// A lamp gives no more than it is said to, but for what rounding and coarse angles make of the sum.
constexpr double kMostExcess = 1.05;
// "0" and a blank: no number takes less.
constexpr std::uint64_t kLeastNumberBytes = 2;

/// Numbers that follow each other over lines, between blanks and commas.
class Numbers {
 public:
  explicit Numbers(TextCursor& cursor) : cursor_(cursor) {}

  /// Empty at the end of the file.
  std::string_view word() {
    while (true) {
      const std::size_t begin = std::min(token_.find_first_not_of(','), token_.size());
      token_.remove_prefix(begin);
      if (!token_.empty()) break;
      token_ = cursor_.next_token();
      if (token_.empty() && !cursor_.next_line()) return {};
    }
    const std::string_view word = token_.substr(0, token_.find(','));
    token_.remove_prefix(word.size());
    return word;
  }

 private:
  TextCursor& cursor_;
  std::string_view token_;
};

class IesReader {
 public:
  explicit IesReader(const Input& input)
      : input_(input),
        cursor_(input.bytes, input.limits.line_bytes),
        numbers_(cursor_),
        builder_(luminaire(input, "ies", 1)) {}

  ReadResult run() {
    if (read_keywords() && read_tilt() && read_figures() && read_angles() && read_intensities()) judge();
    if (cursor_.passed_line_limit())
      fault("a line is longer than " + std::to_string(input_.limits.line_bytes) + " bytes");
    return {builder_.take(), std::move(issues_)};
  }

 private:
  bool read_keywords() {
    constexpr std::string_view kTilt = "TILT=";
    while (cursor_.next_line()) {
      const std::string_view line = cursor_.rest();
      if (!line.starts_with(kTilt)) continue;
      tilt_ = line.substr(kTilt.size());
      tilt_line_ = cursor_.line();
      cursor_.next_line();
      return true;
    }
    return fault("no line TILT= follows the keywords");
  }

  bool read_tilt() {
    if (tilt_ == "NONE") return true;
    issues_.add(issue_at_line(ReadIssueKind::TiltUnsupported,
                              tilt_ == "INCLUDE" ? "intensities that change with the tilt of the lamp are listed"
                                                 : "intensities that change with the tilt of the lamp stand in another "
                                                   "file, " +
                                                       in_quotes(tilt_),
                              tilt_line_));
    if (tilt_ != "INCLUDE") return true;
    const auto geometry = number("the place of the lamp"), pairs = number("the number of tilt angles");
    if (!geometry || !pairs || !fits(*pairs, 2)) return false;
    return read_list(2 * static_cast<std::size_t>(*pairs), "tilt angles and factors").has_value();
  }

  bool read_figures() {
    const auto lamps = number("the number of lamps"), lumens = number("the lumens of a lamp"),
               multiplier = number("the multiplier of intensities"), vertical = number("the number of vertical angles"),
               horizontal = number("the number of horizontal angles"), type = number("the type of planes"),
               unit = number("the unit of lengths");
    if (!lamps || !lumens || !multiplier || !vertical || !horizontal || !type || !unit) return false;
    for (const char* what :
         {"the width", "the length", "the height", "the ballast factor", "the reserved number", "the watts"}) {
      if (!number(what)) return false;
    }
    if (*lamps < 1 || std::floor(*lamps) != *lamps) return fault("the number of lamps is no count");
    if (*lumens <= 0 && *lumens != -1) return fault("the lumens of a lamp are neither positive nor -1");
    if (!(*multiplier > 0)) return fault("the multiplier of intensities is not positive");
    if (*type != 1 && *type != 2 && *type != 3) return fault("the type of planes is none of 1, 2 and 3");
    if (*unit != 1 && *unit != 2) return fault("the unit of lengths is neither 1 (feet) nor 2 (metres)");
    if (!fits(*vertical, 1) || !fits(*horizontal, *vertical)) return false;
    photometry_.type = static_cast<PlaneType>(static_cast<int>(*type));
    builder_.scene().metres_per_unit = *unit == 1 ? kMetresPerFoot : 1;
    stated_ = *lumens == -1 ? std::nullopt : std::optional(*lamps * *lumens);
    multiplier_ = *multiplier;
    vertical_ = static_cast<std::size_t>(*vertical);
    horizontal_ = static_cast<std::size_t>(*horizontal);
    return true;
  }

  bool read_angles() {
    auto vertical = read_list(vertical_, "vertical angles");
    if (!vertical || !are_ascending(*vertical)) return vertical ? fault("vertical angles do not ascend") : false;
    auto horizontal = read_list(horizontal_, "horizontal angles");
    if (!horizontal || !are_ascending(*horizontal))
      return horizontal ? fault("horizontal angles do not ascend") : false;
    photometry_.vertical = std::move(*vertical);
    photometry_.horizontal = std::move(*horizontal);
    return true;
  }

  bool read_intensities() {
    auto list = read_list(vertical_ * horizontal_, "intensities");
    if (!list) return false;
    for (const double value : *list) {
      if (value < 0) return fault("an intensity is negative");
    }
    photometry_.intensity = std::move(*list);
    const std::string_view more = numbers_.word();
    return more.empty() || fault(in_quotes(more) + " follows the last intensity");
  }

  void judge() {
    if (std::string gap = gap_in(photometry_); !gap.empty()) {
      issues_.add(issue_at_line(ReadIssueKind::PlaneGap, std::move(gap), angles_line_));
    }
    if (!stated_) return;
    const double flux = multiplier_ * flux_of(photometry_);
    if (flux <= kMostExcess * *stated_) return;
    issues_.add(issue_at_line(ReadIssueKind::FluxMismatch,
                              "intensities add up to " + std::to_string(std::lround(flux)) + " lm, the lamps give " +
                                  std::to_string(std::lround(*stated_)) + " lm",
                              figures_line_));
  }

  /// Whether the rest of the file can hold `count` times `each` numbers.
  bool fits(double count, double each) {
    const auto room = static_cast<double>(cursor_.bytes_left() / kLeastNumberBytes + 1);
    if (count >= 1 && std::floor(count) == count && count * each <= room) return true;
    return fault("a count of angles is no number that the file has room for");
  }

  std::optional<std::vector<double>> read_list(std::size_t count, const char* what) {
    std::vector<double> list;
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = number(what);
      if (!value) return std::nullopt;
      list.push_back(*value);
      if (i == 0 && photometry_.vertical.empty()) angles_line_ = cursor_.line();
    }
    return list;
  }

  std::optional<double> number(const char* what) {
    const std::string_view word = numbers_.word();
    const auto value = parse_number(word);
    if (value && is_believable(*value)) {
      if (figures_line_ == 0) figures_line_ = cursor_.line();
      return value;
    }
    fault(word.empty() ? std::string("the file ends before ") + what
                       : in_quotes(word) + " is no number; it stands for " + what);
    return std::nullopt;
  }

  bool fault(std::string what) {
    issues_.add(issue_at_line(ReadIssueKind::PhotometrySyntax, std::move(what), cursor_.line()));
    return false;
  }

  const Input& input_;
  TextCursor cursor_;
  Numbers numbers_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  Photometry photometry_;
  std::string tilt_;
  std::optional<double> stated_;  ///< lm of all lamps; nothing where they are not stated
  double multiplier_ = 1;
  std::size_t vertical_ = 0, horizontal_ = 0;
  std::uint64_t tilt_line_ = 0, figures_line_ = 0, angles_line_ = 0;
};

bool sniff(std::string_view head) { return head.starts_with("IESNA"); }

ReadResult read(const Input& input) { return IesReader(input).run(); }

}  // namespace

const Reader ies_reader{"ies", kSuffixes, sniff, read};

}  // namespace rad::readers
