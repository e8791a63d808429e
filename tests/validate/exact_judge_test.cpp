// Nothing that meets in exact arithmetic goes unreported: lint against exact intersections of all pairs of triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "geom/box_tree.h"
#include "tests/support/derived_scene.h"
#include "tests/support/exact_meeting.h"
#include "tests/support/random_scenes.h"
#include "validate/lint.h"

namespace rad::validate {
namespace {

using tests::DerivedScene;
using tests::Meeting;
using Names = std::set<std::string>;

constexpr double kT = tests::kSceneTolerance;

/// Which rules name a face, and which name both of a pair. Faces are numbered from 1, as in the file.
class Reported {
 public:
  explicit Reported(const scene::Scene& scene) {
    LintOptions options;
    options.tolerance = geom::ToleranceRequest{kT, geom::ToleranceRequest::Measure::FileUnits};
    options.group = false;
    for (const scene::Finding& finding : lint(scene, {}, options).findings) {
      const auto& faces = finding.where.faces;
      const std::string rule(finding.rule);
      for (const scene::FaceReference& face : faces) of_face_[face.line].insert(rule);
      if (faces.size() == 2) of_pair_[std::minmax(faces[0].line, faces[1].line)].insert(rule);
    }
  }

  [[nodiscard]] bool pair(FaceId a, FaceId b, const Names& rules) const {
    const auto found = of_pair_.find(std::minmax<std::uint64_t>(a + 1, b + 1));
    return found != of_pair_.end() && any_of(found->second, rules);
  }
  [[nodiscard]] bool face(FaceId face, const Names& rules) const {
    const auto found = of_face_.find(face + 1);
    return found != of_face_.end() && any_of(found->second, rules);
  }

 private:
  static bool any_of(const Names& names, const Names& rules) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return rules.contains(name); });
  }

  std::map<std::uint64_t, Names> of_face_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, Names> of_pair_;
};

const Names kOverlaps{"RL114", "RL220", "RL221", "RL222"};
const Names kPassages{"RL210", "RL211"};
const Names kNearMisses{"RL201", "RL301", "RL302"};

// Calls judge(i, j, meeting) for all pairs of triangles of different faces that meet.
template <typename Judge>
void for_each_meeting(const DerivedScene& scene, const Judge& judge) {
  const auto& all = scene.triangles;
  for (std::size_t i = 0; i < all.triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < all.triangles.size(); ++j) {
      if (all.triangles[i].face == all.triangles[j].face) continue;
      const auto &a = all.geometry[i].points, &b = all.geometry[j].points;
      if (!geom::box_of(a).meets(geom::box_of(b))) continue;
      const Meeting meeting = tests::exact_meeting(a, b);
      if (meeting != Meeting::Apart) judge(i, j, meeting);
    }
  }
}

TEST(ExactJudge, EveryMeetingOnACoarseGridIsNamedByItsFaces) {
  std::map<Meeting, int> seen;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const DerivedScene scene(tests::coarse_scene(seed), kT);
    const Reported reported(scene.scene);
    for_each_meeting(scene, [&](std::size_t i, std::size_t j, Meeting meeting) {
      const FaceId a = scene.triangles.triangles[i].face, b = scene.triangles.triangles[j].face;
      ++seen[meeting];
      if (meeting == Meeting::Area) {
        EXPECT_TRUE(reported.pair(a, b, kOverlaps)) << "seed " << seed << " faces " << a + 1 << ' ' << b + 1;
      }
      if (meeting == Meeting::PointInside || meeting == Meeting::AlongOneEdge || meeting == Meeting::Through) {
        const bool named = reported.pair(a, b, kPassages) || reported.pair(a, b, kOverlaps);
        EXPECT_TRUE(named) << meeting << " seed " << seed << " faces " << a + 1 << ' ' << b + 1;
      }
    });
  }
  EXPECT_EQ(seen.size(), 7U) << "not every way to meet was tried";
}

bool beyond_vertices_and_edges(Meeting meeting) {
  return meeting != Meeting::CommonVertex && meeting != Meeting::AlongBothEdges && meeting != Meeting::VertexOnEdge;
}

TEST(ExactJudge, EveryMeetingNearTheToleranceIsReportedAtItsFaces) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const DerivedScene scene(tests::fine_scene(seed), kT);
    const Reported reported(scene.scene);
    for_each_meeting(scene, [&](std::size_t i, std::size_t j, Meeting meeting) {
      if (!beyond_vertices_and_edges(meeting)) return;
      const FaceId a = scene.triangles.triangles[i].face, b = scene.triangles.triangles[j].face;
      const bool named = reported.pair(a, b, kPassages) || reported.pair(a, b, kOverlaps);
      EXPECT_TRUE(named || reported.face(a, kNearMisses) || reported.face(b, kNearMisses))
          << meeting << " seed " << seed << " faces " << a + 1 << ' ' << b + 1;
    });
  }
}

}  // namespace
}  // namespace rad::validate
