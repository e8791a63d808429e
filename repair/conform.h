// From a soup of pieces to the conforming complex: Grouper's planes, Isect's rounds and the residual loop, until the
// lint of the triangles is empty.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "repair/complex.h"
#include "repair/conform_counts.h"
#include "repair/soup.h"
#include "repair/stopwatch.h"
#include "repair/triangle_lint.h"
#include "repair/triangulation.h"

namespace rad::repair {

/// A triangle that a piece gave up to a piece of the same facing.
struct CoveredCell {
  scene::FaceId winner = 0;
  scene::FaceId loser = 0;
  double area = 0;  ///< pitches²
  dvec3 middle{0, 0, 0};
};

struct ConformTimings {
  Spent grouper;  ///< weld, planes, T-vertices
  Spent isect;    ///< plane passes and residual loop

  ConformTimings& operator+=(const ConformTimings& more) {
    grouper += more.grouper;
    isect += more.isect;
    return *this;
  }
};

/// Places where a surface is farther from where it was than it may be.
struct Drift {
  std::size_t places = 0;
  dvec3 first{0, 0, 0};                ///< pitches; one of them
  std::vector<std::uint32_t> origins;  ///< of the surfaces that it is about, ascending
};

struct Conformed {
  std::unique_ptr<Complex> complex;
  Triangulation triangulation;
  std::vector<Violation> violations;    ///< what could not be cured; empty where all could
  std::vector<std::uint32_t> at_fault;  ///< the triangles that show it, and those of maps that fold
  std::vector<CoveredCell> covered;
  double grouped_area = 0;  ///< of the pieces when they were welded and snapped, pitches²
  Drift drift;              ///< measured by the ladder
  bool sound = true;        ///< false where a plane map still folds over itself
  bool untouched = false;   ///< nothing was welded and nothing is wrong
  bool interrupted = false;
  ConformCounts counts;
  ConformTimings timings;

  [[nodiscard]] bool clean() const { return violations.empty() && sound && drift.places == 0; }
};

/// Called between rounds with what is going on; false stops.
using ConformProgress = std::function<bool(const char* step, std::size_t left)>;

/// The surfaces that splits and merges may draw no farther than is promised: those are refused then, and what they were
/// to cure is cut or stays. All others may be drawn as far as it takes.
struct Held {
  bool all = false;
  std::vector<std::uint32_t> origins;  ///< places among Soup::origins, ascending
};

/// Which filters do their part on the whole of the soup. What is left out leaves its timings and counts at zero, and
/// nothing is linted where Isect is.
struct ConformSteps {
  bool group = true;
  bool cut = true;
};

/// `tolerance` is T in pitches, which the lint holds the result against; the work is done at `tolerance · scale`. What
/// nothing is wrong with stays as it is.
Conformed conform(Soup soup, std::int64_t tolerance, double scale, const Held& held, const ConformProgress& progress);
/// Some of the filters at T, with every piece in the complex.
Conformed conform(Soup soup, std::int64_t tolerance, const ConformProgress& progress, ConformSteps steps);
/// Isect's part on a complex that has been grouped, which says at what tolerance to work.
Conformed cut(std::unique_ptr<Complex> grouped, std::int64_t tolerance, const ConformProgress& progress);
/// Goes on with what an attempt left, at another scale: only what is at fault there is welded and worked on.
Conformed conform_rest(const Conformed& attempt, std::int64_t tolerance, double scale, const Held& held,
                       const ConformProgress& progress);

}  // namespace rad::repair
