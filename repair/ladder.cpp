#include "repair/ladder.h"

#include <array>
#include <optional>

#include "repair/drift.h"

namespace rad::repair {
namespace {

constexpr std::array kStarts{1.0, 1.1, 1.3};
constexpr std::array kLocalScales{1.05, 1.1, 1.2, 1.3, 1.4, 1.6};

class Ladder {
 public:
  Ladder(const Soup& soup, std::int64_t tolerance, const ConformProgress& progress)
      : soup_(soup), tolerance_(tolerance), progress_(progress) {}

  Conformed climb() {
    for (const double start : kStarts) {
      if (done(start, Drawing::Free)) break;
      // What drew surfaces too far is done once more without that.
      if (drifted_ && done(start, Drawing::Bounded)) break;
    }
    best_->timings = spent_;
    best_->untouched = untouched_;
    return std::move(*best_);
  }

 private:
  // True where nothing more is to be tried.
  bool done(double start, Drawing drawing) {
    Conformed attempt = conform(soup_, tolerance_, start, drawing, progress_);
    untouched_ = untouched_ || attempt.untouched;  // whatever is done about opposite overlaps
    for (const double scale : kLocalScales) {
      if (attempt.clean() || attempt.interrupted) break;
      attempt = conform_rest(attempt, tolerance_, start * scale, drawing, progress_);
    }
    spent_ += attempt.timings;
    const bool interrupted = attempt.interrupted;
    attempt.drift = drift_of(attempt, soup_, tolerance_);
    drifted_ = attempt.violations.empty() && attempt.drift.places > 0;
    if (!best_ || better(attempt, *best_)) best_ = std::move(attempt);
    best_->interrupted = interrupted;
    return best_->clean() || interrupted;
  }

  static bool better(const Conformed& a, const Conformed& b) {
    const auto left = [](const Conformed& attempt) { return attempt.violations.size() + attempt.drift.places; };
    return a.clean() || (a.sound >= b.sound && left(a) < left(b));
  }

  const Soup& soup_;
  std::int64_t tolerance_;
  const ConformProgress& progress_;
  std::optional<Conformed> best_;
  ConformTimings spent_;
  bool untouched_ = false;
  bool drifted_ = false;  ///< the last attempt has no other fault than that it drew surfaces too far
};

}  // namespace

Conformed climb(const Soup& soup, std::int64_t tolerance, const ConformProgress& progress) {
  return Ladder(soup, tolerance, progress).climb();
}

}  // namespace rad::repair
