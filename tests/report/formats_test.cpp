#include "report/formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "report/concise.h"
#include "report/csv.h"
#include "report/github.h"
#include "report/json.h"
#include "report/markdown.h"
#include "report/printable.h"
#include "report/text_layout.h"
#include "sample_reports.h"
#include "schema_checker.h"

namespace rad::report {
namespace {

using samples::broken_input;
using samples::clean_input;
using samples::hostile_input;
using samples::report_on;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Fields of a text as RFC 4180 has them.
std::vector<std::vector<std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') {
      rows.back().back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      rows.back().emplace_back();
    } else if (c == '\n' && !quoted) {
      rows.push_back({""});
    } else {
      rows.back().back() += c;
    }
  }
  rows.pop_back();
  return rows;
}

TEST(Formats, AllAreFoundByName) {
  for (const ReportFormat& format : report_formats()) EXPECT_EQ(find_report_format(format.name), &format);
  EXPECT_EQ(find_report_format("yaml"), nullptr);
  EXPECT_THAT(report_format_names(), StartsWith("text, "));
}

// A page's own script and style hold tabs.
std::string without_scripts(std::string out) {
  for (const auto& [opening, closing] : {std::pair{"<script", "</script>"}, std::pair{"<style", "</style>"}}) {
    for (std::size_t at = out.find(opening); at != std::string::npos; at = out.find(opening, at)) {
      out.erase(at, out.find(closing, at) - at);
    }
  }
  return out;
}

// Whatever a file says, every format stays UTF-8 without controls, but for its own line ends. JSON keeps names as they
// are, in its own escapes; HTML has tests of its own.
TEST(Formats, HostileNamesSteerNothing) {
  for (const ReportFormat& format : report_formats()) {
    if (format.name == "json" || format.name == "jsonl" || format.name == "html") continue;
    const std::string out = without_scripts(format.write(report_on({hostile_input()}), {}));
    for (const std::string& line : lines_of(out)) EXPECT_EQ(line, printable(line)) << format.name;
  }
}

TEST(Formats, HostileNamesStayJson) {
  for (const char* name : {"json", "jsonl", "sarif"}) {
    EXPECT_TRUE(nlohmann::json::accept(find_report_format(name)->write(report_on({hostile_input()}), {}))) << name;
  }
}

TEST(Formats, SameReportSameBytes) {
  for (const ReportFormat& format : report_formats()) {
    const Report report = report_on({broken_input(), clean_input("b.obj"), samples::unreadable_input()});
    EXPECT_EQ(format.write(report, {}), format.write(report, {})) << format.name;
  }
}

TEST(Concise, LineForEachFinding) {
  EXPECT_THAT(lines_of(concise(report_on({broken_input(), clean_input("b.obj")}))),
              testing::ElementsAre(
                  "room.obj:120: error: 3 T-vertices on an edge of \"floor\" at (1.25, 0, 3.5) [RL201 t-vertex]",
                  "room.obj:9: error: 3 T-vertices on an edge of \"floor\" at (10, 0, 3.5) [RL201 t-vertex]",
                  "room.obj:7: note: open surface [RL101 open-boundary]", "2 errors, 1 note in 2 files"));
}

TEST(JsonLines, EveryLineIsAReportOfOneInput) {
  const SchemaChecker checker("report.schema.json");
  const auto lines = lines_of(json_lines(report_on({broken_input(), clean_input("b.obj")})));
  ASSERT_EQ(lines.size(), 2U);
  for (const std::string& line : lines) {
    EXPECT_THAT(checker.faults(nlohmann::json::parse(line)), testing::IsEmpty());
  }
  EXPECT_EQ(nlohmann::json::parse(lines[1])["inputs"][0]["path"], "b.obj");
  EXPECT_EQ(nlohmann::json::parse(lines[1])["verdict"], "pass");
}

TEST(Csv, RowForEachFinding) {
  const auto rows = csv_rows(csv(report_on({broken_input()})));
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(rows[1][0], "room.obj");
  EXPECT_EQ(rows[1][1], "120");
  EXPECT_EQ(rows[1][9], "3 T-vertices on an edge of \"floor\"");
  EXPECT_EQ(rows[1][11], "0");
  EXPECT_EQ(rows[1][14], "1.25");
  EXPECT_EQ(rows[3][14], "");
}

TEST(Csv, NoCellIsAFormula) {
  for (const auto& row : csv_rows(csv(report_on({hostile_input()})))) {
    for (const std::string& cell : row) {
      if (!cell.empty() && std::string("=+@").find(cell[0]) != std::string::npos) ADD_FAILURE() << cell;
    }
  }
}

TEST(Github, AnnotationsThenText) {
  const auto lines = lines_of(github(report_on({broken_input()}), {}));
  EXPECT_EQ(
      lines[0],
      "::error file=room.obj,line=120,title=RL201 t-vertex::3 T-vertices on an edge of \"floor\" at (1.25, 0, 3.5)");
  EXPECT_THAT(lines[2], StartsWith("::notice file=room.obj,line=7,title=RL101 open-boundary::"));
  EXPECT_THAT(lines.back(), StartsWith("      radlint rule"));
}

TEST(Github, ShowsTenOfEachSeverity) {
  InputReport input = clean_input();
  for (int i = 0; i < 30; ++i) input.result.findings.push_back(samples::t_vertex(1, i));
  const auto lines = lines_of(github(report_on({input}), {}));
  EXPECT_EQ(std::ranges::count_if(lines, [](const std::string& line) { return line.starts_with("::"); }), 10);
}

TEST(Github, NamesGiveNoCommands) {
  InputReport input = hostile_input();
  input.path = "::stop-commands::x";
  for (const std::string& line : lines_of(github(report_on({input}), {}))) {
    if (!line.starts_with("::")) continue;
    EXPECT_THAT(line, testing::ContainsRegex("^::(error|notice) file=dir/[^:]*,line="));
  }
}

TEST(Markdown, VerdictRulesAndFindings) {
  const std::string out = markdown(report_on({broken_input(), clean_input("b.obj")}));
  EXPECT_THAT(out, StartsWith("<!-- radlint-report -->\n## radlint: **FAIL**\n\n2 errors, 1 note in 2 files"));
  EXPECT_THAT(out, HasSubstr("\n| error | RL201 `t-vertex` | "));
  EXPECT_THAT(out, HasSubstr("\n| `room.obj` | 2 | 0 | 1 |\n| `b.obj` | 0 | 0 | 0 |\n"));
  EXPECT_THAT(out, HasSubstr("\n### `room.obj`\n"));
  EXPECT_THAT(out, HasSubstr("\n| error | RL201 | `room.obj:120` at (1.25, 0, 3.5) | 3 T-vertices"));
}

TEST(Markdown, NamesAreNoMarkup) {
  const std::string out = markdown(report_on({hostile_input()}));
  const std::string outside = std::regex_replace(out, std::regex("`[^`\n]*`"), "");  // code is shown as it stands
  EXPECT_THAT(outside, Not(HasSubstr("[x](y)")));
  EXPECT_THAT(outside, Not(HasSubstr("<d>")));
  EXPECT_THAT(out, HasSubstr("@<!-- -->you"));
  for (const std::string& line : lines_of(out)) {
    if (!line.starts_with("| error | RL201 | ")) continue;
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
    EXPECT_EQ(bars, 5U) << line;
  }
}

TEST(Markdown, StaysBelowTheLimit) {
  std::vector<InputReport> inputs;
  for (int i = 0; i < 2000; ++i) inputs.push_back(broken_input("models/room_" + std::to_string(i) + ".obj"));
  const std::string out = markdown(report_on(inputs));
  EXPECT_LT(out.size(), kMarkdownLimit);
  EXPECT_THAT(out, HasSubstr(counted(4000, "error")));
  EXPECT_THAT(out, HasSubstr("left out of this table"));
  EXPECT_THAT(out, HasSubstr("left out here"));
}

}  // namespace
}  // namespace rad::report
