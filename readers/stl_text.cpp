#include "readers/stl_text.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "readers/refusals.h"
#include "readers/text_cursor.h"
#include "scene/scene_builder.h"

namespace rad::readers {
namespace {

using scene::ReadIssueKind;
using Token = TextCursor::Token;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Keywords are written in any case.
bool is(std::string_view word, std::string_view keyword) { return std::ranges::equal(word, keyword, {}, lower); }

struct Corner {
  scene::dvec3 position;
  std::uint64_t line = 0;
};

class StlTextReader {
 public:
  explicit StlTextReader(const Input& input)
      : input_(input), cursor_(input.bytes, input.limits.line_bytes), builder_(input.path, "stl") {
    builder_.add_section({input.path, {}, scene::RecordKind::Line});
  }

  ReadResult run() {
    while (!stopped_ && cursor_.next_line()) {
      for (std::string_view word = cursor_.next_token(); !word.empty() && !stopped_; word = cursor_.next_token()) {
        read_statement(word);
      }
    }
    if (cursor_.passed_line_limit()) {
      refuse("a line is longer than the limit of " + std::to_string(input_.limits.line_bytes) +
             " bytes; the rest is left out");
    } else if (!stopped_) {
      end_of_file();
    }
    return {builder_.take(), std::move(issues_)};
  }

 private:
  void read_statement(std::string_view word) {
    if (is(word, "vertex")) return read_vertex();
    if (is(word, "facet")) return begin_facet();
    if (is(word, "endfacet")) return end_facet();
    if (is(word, "solid")) return begin_solid();
    if (is(word, "endsolid")) return end_solid();
    if (is(word, "outer") || is(word, "loop") || is(word, "endloop")) return;
    refuse(in_quotes(word) + " is not a statement of ASCII STL");
    cursor_.rest();
  }

  void begin_solid() {
    if (in_facet_) end_facet();
    in_solid_ = true;
    builder_.use_object(builder_.object(cursor_.rest()));
  }

  void end_solid() {
    if (in_facet_) end_facet();
    in_solid_ = false;
    cursor_.rest();
  }

  void begin_facet() {
    if (in_facet_) end_facet();
    in_facet_ = true;
    facet_line_ = cursor_.line();
    corners_.clear();
    skip_normal();
  }

  // The vertices say which way a facet faces; its normal is often zero or stale.
  void skip_normal() {
    TextCursor ahead = cursor_;
    if (!is(ahead.next_token(), "normal")) return;
    double ignored = 0;
    for (int axis = 0; axis < 3; ++axis) {
      cursor_ = ahead;
      if (ahead.next_number(ignored) == Token::Absent) return;
    }
    cursor_ = ahead;
  }

  void read_vertex() {
    if (!in_facet_) {
      cursor_.rest();
      return refuse("a vertex stands outside a facet");
    }
    Corner corner{scene::dvec3(std::numeric_limits<double>::quiet_NaN()), cursor_.line()};
    for (int axis = 0; axis < 3; ++axis) {
      const Token token = cursor_.next_number(corner.position[axis]);
      if (token == Token::Good) continue;
      refuse(token == Token::Bad ? in_quotes(cursor_.bad_token()) + " is not a number"
                                 : "a vertex needs three coordinates, this one has " + std::to_string(axis));
      if (token == Token::Absent) break;
    }
    if (corners_.size() <= kFacetCorners) corners_.push_back(corner);
  }

  void end_facet() {
    if (!in_facet_) return refuse("endfacet stands outside a facet");
    in_facet_ = false;
    if (corners_.size() != kFacetCorners) {
      const std::string count = corners_.size() > kFacetCorners ? "more than 3" : std::to_string(corners_.size());
      issues_.add(issue_at_line(ReadIssueKind::ParseError,
                                "a facet needs three vertices, this one has " + count + "; it is left out",
                                facet_line_));
      return;
    }
    std::string full = limit_before_face(builder_.scene(), kFacetCorners, input_.limits);
    if (full.empty()) full = limit_before_vertices(builder_.scene(), kFacetCorners, input_.limits);
    if (!full.empty()) {
      stopped_ = true;
      return refuse(std::move(full));
    }
    std::array<scene::VertexId, kFacetCorners> ids{};
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = builder_.add_vertex(corners_[i].position, corners_[i].line);
    builder_.add_face(ids, facet_line_);
  }

  void end_of_file() {
    if (in_facet_) {
      refuse("the file ends within a facet");
      if (corners_.size() == kFacetCorners) end_facet();
    } else if (in_solid_) {
      refuse("the file ends before endsolid");
    }
  }

  void refuse(std::string what) {
    issues_.add(issue_at_line(ReadIssueKind::ParseError, std::move(what), cursor_.line()));
  }

  static constexpr std::size_t kFacetCorners = 3;

  const Input& input_;
  TextCursor cursor_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  std::vector<Corner> corners_;
  std::uint64_t facet_line_ = 0;
  bool in_solid_ = false;
  bool in_facet_ = false;
  bool stopped_ = false;
};

}  // namespace

ReadResult read_text_stl(const Input& input) { return StlTextReader(input).run(); }

}  // namespace rad::readers
