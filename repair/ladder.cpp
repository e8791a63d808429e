#include "repair/ladder.h"

#include <array>
#include <optional>

namespace rad::repair {
namespace {

constexpr std::array kStarts{1.0, 1.1, 1.3};
constexpr std::array kLocalScales{1.05, 1.1, 1.2, 1.3, 1.4, 1.6};

bool better(const Conformed& a, const Conformed& b) {
  return a.clean() || (a.sound >= b.sound && a.violations.size() < b.violations.size());
}

}  // namespace

Conformed climb(const Soup& soup, std::int64_t tolerance, const ConformProgress& progress) {
  std::optional<Conformed> best;
  ConformTimings spent;
  bool untouched = false;
  for (const double start : kStarts) {
    Conformed attempt = conform(soup, tolerance, start, progress);
    untouched = untouched || attempt.untouched;  // whatever is done about opposite overlaps
    for (const double scale : kLocalScales) {
      if (attempt.clean() || attempt.interrupted) break;
      attempt = conform_rest(attempt, tolerance, start * scale, progress);
    }
    spent += attempt.timings;
    const bool interrupted = attempt.interrupted;
    if (!best || better(attempt, *best)) best = std::move(attempt);
    best->interrupted = interrupted;
    if (best->clean() || interrupted) break;
  }
  best->timings = spent;
  best->untouched = untouched;
  return std::move(*best);
}

}  // namespace rad::repair
