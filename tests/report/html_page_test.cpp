#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "report/html/assets.h"
#include "report/html/model_view.h"
#include "report/html/page.h"
#include "tests/bake/drawn_scenes.h"
#include "tests/report/sample_reports.h"

namespace rad::report::html {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t occurrences(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The page without its script and style.
std::string without_assets(const Report& report) {
  std::string text = page(report);
  for (const Asset* asset : {&page_style(), &page_script()}) {
    const std::size_t at = text.find(asset->text);
    EXPECT_NE(at, std::string::npos);
    text.erase(at, asset->text.size());
  }
  return text;
}

/// A box that has one finding with a place.
InputReport shown_input(const std::string& path = "box.obj") {
  InputReport input = samples::clean_input(path);
  scene::Finding finding = samples::t_vertex(3, 1);
  finding.where.face_ids = {1};
  finding.where.places = {{finding.where.point, finding.where.segment}};
  input.result.findings = {finding};
  const scene::Scene scene = tests::box_scene(tests::Facing::Outward);
  input.view = std::make_shared<const ModelView>(model_view(scene, input, 100).value());
  return input;
}

TEST(HtmlPage, SaysTheVerdictAndTheCounts) {
  const std::string failing = without_assets(samples::report_on({samples::broken_input()}));
  EXPECT_THAT(failing, HasSubstr("data-verdict=\"fail\""));
  EXPECT_THAT(failing, HasSubstr("<li class=\"error some\" data-count=\"2\">"));
  EXPECT_EQ(occurrences(failing, "<li class=\"finding "), 3u);
  const std::string passing = without_assets(samples::report_on({samples::clean_input()}));
  EXPECT_THAT(passing, HasSubstr("data-verdict=\"pass\""));
  EXPECT_THAT(passing, HasSubstr("Nothing was found."));
}

TEST(HtmlPage, AllowsItsOwnStyleAndScriptAndNothingElse) {
  const std::string text = without_assets(samples::report_on({samples::broken_input()}));
  EXPECT_THAT(text, HasSubstr(std::string("default-src 'none'; script-src '") + std::string(page_script().hash) +
                              "'; style-src '" + std::string(page_style().hash) + "'; img-src data:;"));
  EXPECT_THAT(text, Not(HasSubstr("unsafe-")));
  EXPECT_THAT(text, Not(HasSubstr(" style=")));
  EXPECT_THAT(text, Not(HasSubstr("http:")));
  EXPECT_THAT(text, Not(HasSubstr("https:")));
}

TEST(HtmlPage, NamesStayText) {
  const std::string hostile = "</script><script>alert(1)</script><img src=x>\" onload='";
  InputReport input = samples::broken_input(hostile);
  for (scene::Finding& finding : input.result.findings) {
    finding.message = finding.where.file = hostile;
    finding.where.objects = finding.where.materials = {hostile};
    finding.where.faces = {{hostile, 0, hostile}};
  }
  const std::string clean = without_assets(samples::report_on({samples::broken_input()}));
  const std::string text = without_assets(samples::report_on({input}));
  EXPECT_EQ(occurrences(text, "<script"), occurrences(clean, "<script"));
  EXPECT_EQ(occurrences(text, "</script"), occurrences(clean, "</script"));
  EXPECT_EQ(occurrences(text, "<img"), occurrences(clean, "<img"));
  EXPECT_THAT(text, Not(HasSubstr("src=x>")));
}

TEST(HtmlPage, HoldsModelAndPicturesWhereTheyWereMade) {
  const std::string with = page(samples::report_on({shown_input()}));
  EXPECT_EQ(occurrences(with, "class=\"geometry\""), 1u);
  EXPECT_THAT(with, HasSubstr("class=\"thumb\""));
  EXPECT_THAT(with, HasSubstr("class=\"fly\""));
  const std::string without = without_assets(samples::report_on({samples::broken_input()}));
  EXPECT_EQ(occurrences(without, "class=\"geometry\""), 0u);
  EXPECT_THAT(without, Not(HasSubstr("<img")));
}

TEST(HtmlPage, SeveralInputsHaveSections) {
  const std::string text = without_assets(
      samples::report_on({shown_input("a.obj"), samples::clean_input("b.obj"), samples::unreadable_input()}));
  EXPECT_EQ(occurrences(text, "<section class=\"model\""), 3u);
  EXPECT_THAT(text, HasSubstr("<a href=\"#model-2\">torn.ply</a>"));
}

TEST(HtmlPage, IsTheSameEachTime) {
  EXPECT_EQ(page(samples::report_on({shown_input()})), page(samples::report_on({shown_input()})));
}

TEST(HtmlPage, ListsAsManyFindingsAsAsked) {
  Report report = samples::report_on({samples::broken_input()});
  report.max_issues = 1;
  const std::string text = without_assets(report);
  EXPECT_EQ(occurrences(text, "<li class=\"finding "), 2u);
  EXPECT_THAT(text, HasSubstr("1 more are not listed"));
}

TEST(ModelView, OfALargeModel_KeepsTheFacesAtFault) {
  scene::SceneBuilder builder("grid.obj", "obj");
  builder.add_section({"grid.obj", "", scene::RecordKind::Line});
  const int side = 460;
  std::vector<scene::VertexId> row;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) builder.add_vertex({x, y, 0});
  }
  const auto at = [&](int x, int y) { return static_cast<scene::VertexId>(y * (side + 1) + x); };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      builder.add_face(std::array{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)}, 0);
    }
  }
  const scene::Scene scene = builder.take();
  InputReport input = samples::clean_input();
  scene::Finding finding = samples::t_vertex(3, 1);
  finding.where.face_ids = {static_cast<scene::FaceId>(scene.faces.size() - 1)};
  input.result.findings = {finding};
  const ModelView view = model_view(scene, input, 100).value();
  EXPECT_EQ(view.triangles, kShownTriangles);
  EXPECT_EQ(view.triangles + view.left_out, 2 * scene.faces.size());
  ASSERT_EQ(view.faults.size(), 1u);
  ASSERT_EQ(view.faults[0].triangles.size(), 1u);
  EXPECT_EQ(view.faults[0].triangles[0].second, 2u);
}

}  // namespace
}  // namespace rad::report::html
