#include "repair/ladder.h"

#include <algorithm>
#include <array>
#include <optional>

#include "repair/drift.h"

namespace rad::repair {
namespace {

constexpr std::array kStarts{1.0, 1.1, 1.3};
// How often what was drawn too far is held and all is done again from a start; the last time all is held.
constexpr int kHoldings = 4;
constexpr std::array kLocalScales{1.05, 1.1, 1.2, 1.3, 1.4, 1.6};

class Ladder {
 public:
  Ladder(const Soup& soup, std::int64_t tolerance, const ConformProgress& progress)
      : soup_(soup), tolerance_(tolerance), progress_(progress) {}

  Conformed climb() {
    for (const double start : kStarts) {
      if (ends_at(start)) break;
    }
    best_->timings = spent_;
    best_->untouched = untouched_;
    return std::move(*best_);
  }

 private:
  // What drew surfaces too far is done again with those held, in the end with all held.
  bool ends_at(double start) {
    Held held;
    if (done(start, held)) return true;
    for (int again = 0; again < kHoldings && !drifted_.empty(); ++again) {
      held.origins.insert(held.origins.end(), drifted_.begin(), drifted_.end());
      std::sort(held.origins.begin(), held.origins.end());
      held.origins.erase(std::unique(held.origins.begin(), held.origins.end()), held.origins.end());
      held.all = again + 1 == kHoldings;
      if (done(start, held)) return true;
    }
    return false;
  }

  // True where nothing more is to be tried.
  bool done(double start, const Held& held) {
    Conformed attempt = conform(soup_, tolerance_, start, held, progress_);
    untouched_ = untouched_ || attempt.untouched;  // whatever is done about opposite overlaps
    for (const double scale : kLocalScales) {
      if (attempt.clean() || attempt.interrupted) break;
      attempt = conform_rest(attempt, tolerance_, start * scale, held, progress_);
    }
    spent_ += attempt.timings;
    const bool interrupted = attempt.interrupted;
    attempt.drift = drift_of(attempt, soup_, tolerance_);
    drifted_ = attempt.violations.empty() ? attempt.drift.origins : std::vector<std::uint32_t>();
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
  std::vector<std::uint32_t> drifted_;  ///< what the last attempt drew too far, where that is its only fault
};

}  // namespace

Conformed climb(const Soup& soup, std::int64_t tolerance, const ConformProgress& progress) {
  return Ladder(soup, tolerance, progress).climb();
}

}  // namespace rad::repair
