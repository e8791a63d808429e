// Every rule against the models of its folder in corpus/rules. A rule is proved by adding files there, not code here.
#include <gtest/gtest.h>

#include <algorithm>
#include <ios>
#include <iterator>
#include <sstream>

#include "readers/reader.h"
#include "tests/support/rule_fixture.h"
#include "tests/support/scene_invariants.h"
#include "tests/support/scene_variants.h"
#include "validate/lint.h"

namespace rad::validate {

// Found by the test framework: a rule prints as its id, and test names stay the same from build to build.
void PrintTo(const Rule* rule, std::ostream* out) { *out << rule->id; }

namespace {

using scene::Finding;
using tests::RuleFixture;
using Fixtures = std::map<std::string, RuleFixture>;

const std::filesystem::path kFolders = std::filesystem::path(RAD_SOURCE_DIR) / "corpus" / "rules";

std::string folder_name(const Rule& rule) { return std::string(rule.id) + "-" + std::string(rule.alias); }

std::vector<Finding> findings_by(const std::vector<const Rule*>& rules, const scene::Scene& scene,
                                 const scene::ReadIssues& issues) {
  LintOptions options;
  options.rules = rules;
  return lint(scene, issues, options).findings;
}

std::vector<const Rule*> every_rule() { return {all_rules().begin(), all_rules().end()}; }

// What all models without a lamp break, and few fixtures have one.
bool is_about_bare_models(const Rule& rule) { return rule.alias == "no-emitter"; }

std::vector<const Rule*> all_but(const Rule& rule) {
  std::vector<const Rule*> rules;
  std::copy_if(all_rules().begin(), all_rules().end(), std::back_inserter(rules),
               [&](const Rule* other) { return other != &rule && !is_about_bare_models(*other); });
  return rules;
}

std::set<std::string> rules_of(const std::vector<Finding>& findings) {
  std::set<std::string> rules;
  for (const Finding& finding : findings) rules.emplace(finding.rule);
  return rules;
}

std::multiset<std::pair<std::string, std::uint64_t>> counts_of(const std::vector<Finding>& findings) {
  std::multiset<std::pair<std::string, std::uint64_t>> counts;
  for (const Finding& finding : findings) counts.emplace(finding.rule, finding.count);
  return counts;
}

bool any_error(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == scene::Severity::Error; });
}

void print(std::ostream& out, const geom::dvec3& p) { out << " (" << p.x << ' ' << p.y << ' ' << p.z << ')'; }

// All of a finding but the faces and lines it names, to the last bit.
std::string in_full(const Finding& finding) {
  std::ostringstream out;
  out << std::hexfloat << finding.rule << ' ' << name(finding.severity) << ' ' << name(finding.kind) << " \""
      << finding.message << "\" count " << finding.count << " of " << finding.where.face_count << " faces";
  if (finding.measure) out << " measure " << finding.measure->value;
  if (finding.where.point) print(out << " at", *finding.where.point);
  for (const auto& span : {finding.where.segment, finding.where.bounds}) {
    if (!span) continue;
    print(out << " over", (*span)[0]);
    print(out, (*span)[1]);
  }
  for (const std::string& object : finding.where.objects) out << " object " << object;
  for (const std::string& material : finding.where.materials) out << " material " << material;
  out << " fingerprint " << finding.fingerprint;
  return out.str();
}

std::vector<std::string> in_full(const std::vector<Finding>& findings) {
  std::vector<std::string> texts;
  for (const Finding& finding : findings) texts.push_back(in_full(finding));
  return texts;
}

void expect_as_foreseen(const std::vector<Finding>& findings, const RuleFixture& fixture) {
  ASSERT_EQ(findings.size(), fixture.findings.size()) << testing::PrintToString(in_full(findings));
  constexpr double kPlaceAccuracy = 1e-3;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const auto& expected = fixture.findings[i];
    EXPECT_EQ(name(findings[i].severity), expected.severity);
    EXPECT_EQ(findings[i].count, expected.count);
    ASSERT_EQ(findings[i].where.point.has_value(), expected.point.has_value());
    if (!expected.point) continue;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR((*findings[i].where.point)[axis], (*expected.point)[axis], kPlaceAccuracy) << "axis " << axis;
    }
  }
}

class RuleMatrix : public testing::TestWithParam<const Rule*> {
 protected:
  [[nodiscard]] const Rule& rule() const { return *GetParam(); }
  [[nodiscard]] Fixtures fixtures() const { return tests::fixtures_of(kFolders / folder_name(rule())); }

  // A fixture shows one fault: but for the rules of units, it is read as with --units m --up z.
  [[nodiscard]] readers::ReadResult read(const RuleFixture& fixture) const {
    readers::ReadResult read = readers::read_file(fixture.path);
    scene::Scene& scene = read.scene;
    if (fixture.metres_per_unit) scene.metres_per_unit = fixture.metres_per_unit;
    if (rule().requirement == Requirement::Units) return read;
    if (!scene.metres_per_unit) scene.metres_per_unit = 1;
    if (scene.up == scene::UpAxis::Unknown) scene.up = scene::UpAxis::Z;
    return read;
  }

  // Calls `judge` with every model and what was read of it.
  template <typename Judge>
  void for_each_model(const Judge& judge) const {
    for (const auto& [name, fixture] : fixtures()) {
      SCOPED_TRACE(folder_name(rule()) + "/" + name);
      judge(fixture, read(fixture));
    }
  }
};

// What holds for rules about models and about runs alike.
class RuleWords : public testing::TestWithParam<const Rule*> {
 protected:
  [[nodiscard]] static const Rule& rule() { return *GetParam(); }
};

TEST_P(RuleMatrix, HasAFolderWhoseModelsAreAllDescribed) {
  const auto folder = kFolders / folder_name(rule());
  ASSERT_TRUE(std::filesystem::is_directory(folder)) << folder;
  const auto described = fixtures();
  std::set<std::string> names;
  for (const auto& [name, fixture] : described) names.insert(name);
  EXPECT_EQ(tests::model_names(folder), names);
  const auto is_plain = [](const char* stem) {
    return [stem](const auto& item) { return item.second.path.stem() == stem; };
  };
  const auto fail = std::find_if(described.begin(), described.end(), is_plain("fail"));
  const auto pass = std::find_if(described.begin(), described.end(), is_plain("pass"));
  ASSERT_TRUE(fail != described.end() && pass != described.end());
  EXPECT_TRUE(std::includes(fail->second.implied.begin(), fail->second.implied.end(), pass->second.implied.begin(),
                            pass->second.implied.end()))
      << "the good neighbour breaks a rule that the bad one keeps";
}

TEST_P(RuleMatrix, ModelsReadAndAreSilentUnderAnUnrelatedRule) {
  const Rule& unrelated = *find_rule(rule().reports ? "RL114" : "RL001");
  for_each_model([&](const RuleFixture& fixture, const readers::ReadResult& read) {
    EXPECT_EQ(tests::broken_invariant(read.scene), "");
    const bool may_be_damaged = fixture.fails && rule().reports;
    EXPECT_TRUE(may_be_damaged || read.issues.all().empty());
    EXPECT_TRUE(findings_by({&unrelated}, read.scene, read.issues).empty());
  });
}

TEST_P(RuleMatrix, AloneItFindsExactlyWhatIsExpected) {
  for_each_model([&](const RuleFixture& fixture, const readers::ReadResult& read) {
    expect_as_foreseen(findings_by({&rule()}, read.scene, read.issues), fixture);
    EXPECT_EQ(fixture.fails, !fixture.findings.empty());
  });
}

TEST_P(RuleMatrix, OtherRulesFindOnlyWhatIsImplied) {
  for_each_model([&](const RuleFixture& fixture, const readers::ReadResult& read) {
    const auto findings = findings_by(all_but(rule()), read.scene, read.issues);
    EXPECT_EQ(rules_of(findings), fixture.implied) << testing::PrintToString(in_full(findings));
  });
}

TEST_P(RuleMatrix, DefaultsGiveTheSeverityAndTheVerdict) {
  for_each_model([&](const RuleFixture& fixture, const readers::ReadResult& read) {
    const auto all = findings_by(every_rule(), read.scene, read.issues);
    std::vector<Finding> own;
    std::copy_if(all.begin(), all.end(), std::back_inserter(own),
                 [&](const Finding& f) { return f.rule == rule().id; });
    expect_as_foreseen(own, fixture);
    const bool own_error = std::any_of(fixture.findings.begin(), fixture.findings.end(),
                                       [](const auto& finding) { return finding.severity == "error"; });
    EXPECT_TRUE(any_error(all) || !own_error);
    EXPECT_TRUE(!any_error(all) || own_error || !fixture.implied.empty());
  });
}

TEST_P(RuleMatrix, FindingsDoNotDependOnTheOrderInTheFile) {
  for_each_model([&](const RuleFixture&, const readers::ReadResult& read) {
    const auto original = in_full(findings_by(every_rule(), read.scene, read.issues));
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
      const scene::Scene other = tests::rewritten(read.scene, seed);
      EXPECT_EQ(in_full(findings_by(every_rule(), other, read.issues)), original) << "seed " << seed;
    }
  });
}

TEST_P(RuleMatrix, FindingsDoNotDependOnSizeAndPlace) {
  for_each_model([&](const RuleFixture&, const readers::ReadResult& read) {
    const auto original = counts_of(findings_by(every_rule(), read.scene, read.issues));
    for (const int exponent : {-10, 10}) {
      const scene::Scene other = tests::scaled(read.scene, exponent);
      EXPECT_EQ(counts_of(findings_by(every_rule(), other, read.issues)), original) << "scaled by 2^" << exponent;
    }
    const auto elsewhere = tests::moved(read.scene);
    if (!elsewhere) return;
    EXPECT_EQ(counts_of(findings_by(every_rule(), *elsewhere, read.issues)), original) << "moved";
  });
}

TEST_P(RuleWords, SaysAllThatAUserNeeds) {
  const Doc& doc = rule().doc;
  for (const std::string_view text : {doc.what, doc.why, doc.how, doc.fix, doc.modeller, doc.limits}) {
    EXPECT_FALSE(text.empty());
    EXPECT_TRUE(text.empty() || text.back() == '.') << text;
  }
  const bool in_general =
      doc.modeller.starts_with("Nothing to do in any modeller") || doc.modeller.starts_with("In every modeller");
  for (const std::string_view program : {"SketchUp", "Revit", "Rhino", "Blender"}) {
    EXPECT_TRUE(in_general || doc.modeller.find(program) != doc.modeller.npos) << program;
  }
  EXPECT_FALSE(rule().title.empty());
  EXPECT_FALSE(rule().message.empty());
  EXPECT_EQ((rule().check != nullptr) + rule().reports.has_value() + rule().of_tool, 1);
  const bool repairs = rule().fix == scene::FixClass::Safe || rule().fix == scene::FixClass::Unsafe;
  EXPECT_TRUE(!repairs || !rule().fix_operation.empty());
}

TEST_P(RuleWords, ParametersAreNamedAndWithinTheirRange) {
  for (const Parameter& parameter : rule().parameters) {
    EXPECT_EQ(parameter.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos);
    EXPECT_EQ(find_parameter(rule(), parameter.name), &parameter) << "named twice";
    EXPECT_TRUE(parameter.low <= parameter.standard && parameter.standard <= parameter.high) << parameter.name;
    EXPECT_LT(parameter.low, parameter.high) << parameter.name;
    EXPECT_FALSE(parameter.unit.empty() || parameter.what.empty() || parameter.what.back() == '.') << parameter.name;
  }
}

TEST_P(RuleWords, IsNamedAfterItsFault) {
  const std::string_view id = rule().id, alias = rule().alias;
  EXPECT_TRUE(id.size() == 5 && id.starts_with("RL") && id.find_first_not_of("0123456789", 2) == id.npos) << id;
  EXPECT_EQ(alias.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), alias.npos) << alias;
  const bool names_the_remedy = alias.starts_with("no-") && alias != "no-emitter";
  EXPECT_FALSE(names_the_remedy || alias.starts_with("-") || alias.ends_with("-")) << alias;
  EXPECT_EQ(alias.find("--"), alias.npos) << alias;
}

TEST_P(RuleWords, MessageHoldsKnownPlaceholders) {
  const std::set<std::string_view> known{"n",    "s",      "measure", "limit",    "segment",
                                         "area", "advice", "object",  "material", "detail"};
  const std::string_view message = rule().message;
  for (std::size_t at = message.find('{'); at != message.npos; at = message.find('{', at + 1)) {
    const std::string_view placeholder = message.substr(at + 1, message.find('}', at) - at - 1);
    const bool by_number = placeholder.find('|') != placeholder.npos;
    EXPECT_TRUE(by_number || known.contains(placeholder)) << placeholder;
    EXPECT_TRUE(placeholder != "measure" || !rule().measure.name.empty());
    EXPECT_TRUE(placeholder != "limit" || rule().threshold != nullptr);
  }
}

TEST_P(RuleMatrix, MessagesHaveAllPlaceholdersFilled) {
  for_each_model([&](const RuleFixture&, const readers::ReadResult& read) {
    for (const Finding& finding : findings_by({&rule()}, read.scene, read.issues)) {
      EXPECT_EQ(finding.message.find_first_of("{}"), std::string::npos) << finding.message;
    }
  });
}

std::vector<const Rule*> rules_about_models() {
  std::vector<const Rule*> rules = every_rule();
  std::erase_if(rules, [](const Rule* rule) { return rule->of_tool; });
  return rules;
}

INSTANTIATE_TEST_SUITE_P(Rules, RuleMatrix, testing::ValuesIn(rules_about_models()),
                         [](const auto& tested) { return std::string(tested.param->id); });

INSTANTIATE_TEST_SUITE_P(Rules, RuleWords, testing::ValuesIn(all_rules().begin(), all_rules().end()),
                         [](const auto& tested) { return std::string(tested.param->id); });

TEST(RuleFolders, EachBelongsToARule) {
  std::set<std::string> expected, found;
  for (const Rule* rule : rules_about_models()) expected.insert(folder_name(*rule));
  for (const auto& entry : std::filesystem::directory_iterator(kFolders)) {
    found.insert(entry.path().filename().string());
  }
  EXPECT_EQ(found, expected);
}

TEST(RuleNames, AreUnique) {
  std::set<std::string_view> names;
  for (const Rule* rule : all_rules()) {
    EXPECT_TRUE(names.insert(rule->id).second) << rule->id;
    EXPECT_TRUE(names.insert(rule->alias).second) << rule->alias;
  }
}

}  // namespace
}  // namespace rad::validate
