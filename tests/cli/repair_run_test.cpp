// Roll-back: a filter that makes anything worse is not used, and that is said.
#include "cli/repair_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "run.h"

namespace rad::cli {
namespace {

using scene::Filter;
using scene::FilterSet;
using testing::ElementsAre;
using testing::HasSubstr;

// Repairs, then turns one face of the result over and owns up to it.
repair::Repaired spoilt(const scene::Scene& scene, const scene::ReadIssues& issues,
                        const repair::RepairOptions& options) {
  repair::Repaired result = repair::repair(scene, issues, options);
  if (result.model.faces.empty()) return result;
  scene::ConformingModel& model = result.model;
  const scene::ConformingFace& face = model.faces.back();
  for (std::uint32_t i = 0; i < face.triangle_count; ++i) {
    std::swap(model.triangles[face.first_triangle + i][1], model.triangles[face.first_triangle + i][2]);
  }
  for (const scene::Loop& loop : model.loops_of(face)) {
    std::reverse(model.corners.begin() + loop.first, model.corners.begin() + loop.first + loop.count);
  }
  result.turned.reset();
  result.untouched = false;
  result.unresolved = 1;
  return result;
}

class RollBack : public InFolder {
 protected:
  RepairRun run(const RepairFunction& repair) {
    FixCommand command;
    command.input = write("box.obj", kBox);
    command.filters = scene::kRepairFilters;
    const Model model = read_model(command.input, command.model);
    std::ostringstream err;
    LiveLine line(err, false);
    const InterruptWatch watch;
    return run_repair(model, command, {}, line, watch, repair);
  }

  static std::vector<std::string> roll_backs(const RepairRun& run) {
    std::vector<std::string> stages;
    for (const scene::LedgerEntry& entry : run.repaired.ledger) {
      if (entry.operation == "roll-back") stages.push_back(entry.stage);
    }
    return stages;
  }
};

TEST_F(RollBack, LeavesGoodWorkAlone) {
  const RepairRun result = run(&repair::repair);
  EXPECT_EQ(result.done, scene::kRepairFilters);
  EXPECT_TRUE(result.rolled_back.empty());
  EXPECT_TRUE(roll_backs(result).empty());
}

TEST_F(RollBack, TakesBackTheFilterThatMadeItWorse) {
  const RepairRun result = run([](const auto& scene, const auto& issues, const repair::RepairOptions& options) {
    return options.filters.has(Filter::Orient) ? spoilt(scene, issues, options)
                                               : repair::repair(scene, issues, options);
  });
  EXPECT_EQ(result.done, FilterSet::until(Filter::Coplanar));
  EXPECT_THAT(roll_backs(result), ElementsAre("orient"));
  ASSERT_EQ(result.rolled_back.size(), 1u);
  EXPECT_THAT(result.rolled_back[0], HasSubstr("orient is rolled back: it would raise RL110 from 0 to 4"));
  EXPECT_EQ(result.repaired.ledger.back().rules, std::vector<std::string>{"RL110"});
  EXPECT_FALSE(result.all_rolled_back);
}

TEST_F(RollBack, UsesNothingWhereEveryFilterMakesItWorse) {
  const RepairRun result = run(&spoilt);
  EXPECT_TRUE(result.all_rolled_back);
  EXPECT_TRUE(result.done.empty());
  EXPECT_THAT(roll_backs(result), ElementsAre("orient", "coplanar", "isect", "grouper", "orient"));
}

}  // namespace
}  // namespace rad::cli
