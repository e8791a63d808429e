// Radiance scene descriptions: primitives, and the commands that place other files.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <optional>

#include "readers/child_output.h"
#include "readers/companion_path.h"
#include "readers/file_bytes.h"
#include "readers/rad_modifiers.h"
#include "readers/rad_shapes.h"
#include "readers/rad_words.h"
#include "readers/rad_xform.h"
#include "readers/radiance_material.h"
#include "readers/reader.h"
#include "readers/recorded_comment.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader rad_reader;

namespace radiance {
namespace {

using scene::ReadIssueKind;

constexpr std::array<std::string_view, 1> kSuffixes = {".rad"};
constexpr std::uint64_t kMostCommandBytes = 1ull << 30;
constexpr std::chrono::seconds kPatience{600};  ///< with a command
constexpr std::uint64_t kDeepestNesting = 32;   ///< of files that place files
/// Where the primitives of a file are placed.
struct Placement {
  glm::dmat4 world{1.0};
  std::string prefix;
  std::optional<Definition> modifier;  ///< of all surfaces
  bool inverted = false;
  std::filesystem::path folder;  ///< of the file, relative to the model's
  std::uint64_t depth = 0;
  std::optional<std::uint64_t> command_line;  ///< of the command that the text comes from
};

class RadReader {
 public:
  explicit RadReader(const Input& input) : input_(input), builder_(input.path, "rad"), modifiers_(builder_, issues_) {
    builder_.scene().splits_vertices = true;
  }

  ReadResult run() {
    builder_.add_section({input_.path, {}, scene::RecordKind::Line});
    read_record();
    read_text(input_.bytes, Placement());
    return {builder_.take(), std::move(issues_)};
  }

 private:
  // In the comments at the head.
  void read_record() {
    TextCursor cursor(input_.bytes, input_.limits.line_bytes);
    while (cursor.next_line()) {
      const std::string_view line = cursor.rest();
      if (!line.starts_with('#')) return;
      if (const auto record = record_of_comment(line)) builder_.scene().recorded = record;
    }
  }

  [[nodiscard]] scene::IssuePlace place(std::uint64_t line) {
    scene::IssuePlace place;
    if (section_ != 0) place.file = builder_.scene().sections[section_].file;
    place.line = line;
    return place;
  }

  bool refuse(std::string what, std::uint64_t line, ReadIssueKind kind = ReadIssueKind::ParseError) {
    issues_.add({kind, std::move(what), place(line), 1});
    return false;
  }

  void count(std::string what, std::uint64_t line) { issues_.add_unsupported(std::move(what), place(line)); }

  void read_text(std::string_view text, const Placement& placement) {
    Words words(without_byte_order_mark(text));
    while (!full_ && !words.at_end()) {
      if (words.at_command()) {
        const std::string command = words.command();
        follow(command, words.line(), placement);
        continue;
      }
      Primitive primitive;
      if (!read_primitive(words, primitive)) return;
      take(primitive, placement);
    }
  }

  // False where the rest of the text makes no sense any more.
  bool read_primitive(Words& words, Primitive& primitive) {
    primitive.modifier = words.next().substr(0, kLongestName);
    primitive.line = words.line();
    primitive.type = words.next();
    primitive.identifier = words.next().substr(0, kLongestName);
    if (primitive.identifier.empty()) return refuse("the file ends within a primitive", words.line());
    if (primitive.type == "alias") {
      primitive.strings.push_back(words.next());
      return !primitive.strings.back().empty() || refuse("the file ends within an alias", words.line());
    }
    if (!is_surface(primitive.type) && !is_known(primitive.type)) {
      return refuse(in_quotes(primitive.type) + " is not a type of primitive; the rest of the file is left out",
                    primitive.line);
    }
    return read_arguments(words, primitive);
  }

  static bool is_known(std::string_view type) {
    return is_material(type) || is_pattern(type) || type == "source" || type == "instance" || type == "mesh" ||
           type == "spectrum";
  }

  bool read_arguments(Words& words, Primitive& primitive) {
    const auto strings = count_of(words);
    for (std::uint64_t i = 0; strings && i < *strings; ++i) primitive.strings.push_back(words.next());
    const auto integers = strings ? count_of(words) : std::nullopt;
    for (std::uint64_t i = 0; integers && i < *integers; ++i) words.next();
    const auto reals = integers ? count_of(words) : std::nullopt;
    if (!reals) {
      return refuse("the arguments of " + in_quotes(primitive.identifier) +
                        " do not begin with their number; the rest of the file is left out",
                    words.line());
    }
    primitive.reals.reserve(static_cast<std::size_t>(*reals));
    for (std::uint64_t i = 0; i < *reals; ++i) {
      const std::string_view word = words.next();
      if (word.empty())
        return refuse("the file ends within the arguments of " + in_quotes(primitive.identifier), words.line());
      const auto number = parse_number(word);
      if (!number) refuse(in_quotes(word) + " is not a number", words.line());
      primitive.reals.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return true;
  }

  // Every argument takes a byte and a blank at least.
  static std::optional<std::uint64_t> count_of(Words& words) {
    const auto number = parse_integer(words.next());
    if (!number || *number < 0 || static_cast<std::uint64_t>(*number) > words.bytes_left() / 2 + 1) return std::nullopt;
    return static_cast<std::uint64_t>(*number);
  }

  void take(const Primitive& primitive, const Placement& placement) {
    if (is_surface(primitive.type)) {
      add_surface(primitive, placement);
    } else if (primitive.type == "source" || primitive.type == "instance" || primitive.type == "mesh") {
      count(std::string(primitive.type) +
                (primitive.type == "source" ? " primitives (distant light)" : " primitives (compiled files)"),
            primitive.line);
    } else {
      modifiers_.define(primitive, place(primitive.line));
    }
  }

  // By custom the parts of an object are numbered: wall.1, wall.2.
  static std::string_view object_of(std::string_view identifier) {
    const std::size_t dot = identifier.rfind('.');
    if (dot == std::string_view::npos || dot == 0 || dot + 1 == identifier.size()) return identifier;
    const bool numbered = identifier.find_first_not_of("0123456789", dot + 1) == std::string_view::npos;
    return numbered ? identifier.substr(0, dot) : identifier;
  }

  void add_surface(const Primitive& primitive, const Placement& placement) {
    const Definition definition =
        placement.modifier ? *placement.modifier : modifiers_.find(primitive.modifier, place(primitive.line));
    if (definition.is_antimatter) return count("surfaces of antimatter, and what they cut away", primitive.line);
    std::string problem;
    const Shape shape = shape_of(primitive.type, primitive.reals, problem);
    if (!problem.empty()) {
      refuse(problem + " (" + in_quotes(primitive.identifier) + "); it is left out", primitive.line);
      return;
    }
    const std::string identifier = placement.prefix + std::string(primitive.identifier);
    builder_.use_object(builder_.object(object_of(identifier)));
    builder_.use_material(definition.material);
    builder_.use_entity(builder_.add_entity(std::string(primitive.type) + " " + identifier));
    add_shape(shape, placement, placement.command_line.value_or(primitive.line));
  }

  void add_shape(const Shape& shape, const Placement& placement, std::uint64_t line) {
    std::string why = limit_before_vertices(builder_.scene(), shape.points.size(), input_.limits);
    if (why.empty()) why = limit_before_shape(shape);
    if (!why.empty()) {
      full_ = true;
      refuse(std::move(why), line);
      return;
    }
    const auto first = static_cast<scene::VertexId>(builder_.vertex_count());
    for (const geom::dvec3& point : shape.points) {
      builder_.add_vertex(geom::dvec3(placement.world * glm::dvec4(point, 1.0)));
    }
    const bool turned = (glm::determinant(glm::dmat3(placement.world)) < 0) != placement.inverted;
    for (const auto& ring : shape.faces) builder_.add_face(placed_ring(ring, first, turned), line);
    for (const auto& hole : shape.holes) builder_.add_hole(placed_ring(hole, first, turned));
  }

  [[nodiscard]] std::string limit_before_shape(const Shape& shape) {
    std::uint64_t corners = 0;
    for (const auto& ring : shape.faces) {
      if (ring.size() > input_.limits.face_corners)
        return "a face has more corners than the limit; the rest is left out";
      corners += 2 * ring.size();
    }
    return limit_before_face(builder_.scene(), corners, input_.limits);
  }

  static std::vector<scene::VertexId> placed_ring(const std::vector<std::uint32_t>& ring, scene::VertexId first,
                                                  bool turned) {
    std::vector<scene::VertexId> corners;
    for (const std::uint32_t point : ring) corners.push_back(first + point);
    if (turned) std::ranges::reverse(corners);
    return corners;
  }

  // xform is followed, with the files that it names; other programs are not run.
  void follow(const std::string& command, std::uint64_t line, const Placement& outer) {
    const std::vector<std::string> words = words_of(command);
    const bool plain = command.find_first_of("|;<>&$`*?(){}") == std::string::npos;
    if (words.empty()) return;
    if ((!plain || words[0] != "xform") && input_.choices.allow_commands) return run_command(command, line, outer);
    if (!plain || words[0] != "xform")
      return count("commands (" + words[0].substr(0, 40) + "), which are not run", line);
    const Xform xform = parse_xform(std::span(words).subspan(1), input_.limits.instances);
    if (!xform.problem.empty()) {
      refuse("xform " + xform.problem + "; what it places is left out", line);
      return;
    }
    for (const PlacedCopy& copy : xform.copies) {
      for (const std::string& file : xform.files) {
        if (!include(file, line, placed(xform, copy, outer, line))) return;
      }
    }
  }

  // As Radiance does, in the folder of the file.
  void run_command(const std::string& command, std::uint64_t line, const Placement& outer) {
    Placement inner = outer;
    if (++inner.depth > kDeepestNesting) {
      refuse("files place files more than 32 deep; the rest is left out", line);
      return;
    }
    const std::string folder = (input_.directory / outer.folder).string();
    const ChildOutput said = output_of({"/bin/sh", "-c", command}, folder, kMostCommandBytes, kPatience);
    if (!said.problem.empty() || said.text.empty()) {
      refuse("the command " + in_quotes(command) + " gives nothing" + (said.problem.empty() ? "" : ": " + said.problem),
             line, ReadIssueKind::MissingResource);
      return;
    }
    replayed_ += said.text.size();
    if (replayed_ > input_.limits.file_bytes || ++includes_ > input_.limits.instances) {
      full_ = true;
      refuse("files are placed too often; the rest is left out", line);
      return;
    }
    if (!inner.command_line) inner.command_line = line;
    read_text(texts_.emplace_back(said.text), inner);
  }

  static std::vector<std::string> words_of(const std::string& command) {
    std::vector<std::string> words;
    Words cursor(command);
    while (!cursor.at_end()) words.emplace_back(cursor.next());
    return words;
  }

  // What is nearer to the primitive is done to it first.
  Placement placed(const Xform& xform, const PlacedCopy& copy, const Placement& outer, std::uint64_t line) {
    Placement inner = outer;
    inner.world = outer.world * copy.matrix;
    inner.prefix = (outer.prefix + copy.prefix).substr(0, kLongestName);
    if (!outer.modifier && !xform.modifier.empty()) inner.modifier = modifiers_.find(xform.modifier, place(line));
    inner.inverted = outer.inverted != xform.inverted;
    ++inner.depth;
    return inner;
  }

  // Whether there is room for more.
  bool include(const std::string& name, std::uint64_t line, Placement placement) {
    if (full_) return false;
    const std::filesystem::path relative = placement.folder / name;
    const auto path =
        name.starts_with('/') ? std::nullopt : companion_path(input_.directory, relative.generic_string());
    if (!path) {
      refuse("the file " + in_quotes(name) + " lies outside the model's folder and is not opened", line,
             ReadIssueKind::MissingResource);
      return true;
    }
    if (placement.depth > kDeepestNesting)
      return refuse("files place files more than 32 deep; the rest is left out", line);
    if (input_.companions != nullptr) input_.companions->push_back(*path);
    const std::string_view text = text_of(*path, name, line);
    replayed_ += text.size() + 1;
    if (replayed_ > input_.limits.file_bytes || ++includes_ > input_.limits.instances) {
      full_ = true;
      return refuse("files are placed too often; the rest is left out", line);
    }
    placement.folder = relative.parent_path();
    const std::uint32_t outside = section_;
    section_ = section_of(*path);
    builder_.use_section(section_);
    read_text(text, placement);
    section_ = outside;
    builder_.use_section(section_);
    return !full_;
  }

  std::string_view text_of(const std::filesystem::path& path, const std::string& name, std::uint64_t line) {
    const auto [entry, fresh] = files_.try_emplace(path.string());
    if (!fresh) return entry->second == nullptr ? std::string_view() : entry->second->bytes();
    FileBytes& file = opened_.emplace_back();
    const std::string problem = file.open(path, input_.limits.file_bytes, FileKind::Regular);
    if (!problem.empty()) {
      refuse("the file " + in_quotes(name) + " cannot be read: " + problem, line, ReadIssueKind::MissingResource);
      return {};
    }
    entry->second = &file;
    return file.bytes();
  }

  std::uint32_t section_of(const std::filesystem::path& path) {
    const auto [entry, fresh] = sections_.try_emplace(path.string());
    if (fresh) entry->second = builder_.add_section({path.string(), {}, scene::RecordKind::Line});
    return entry->second;
  }

  const Input& input_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  Modifiers modifiers_;
  std::deque<FileBytes> opened_;
  std::deque<std::string> texts_;  ///< of commands
  std::map<std::string, const FileBytes*> files_;
  std::map<std::string, std::uint32_t> sections_;
  std::uint32_t section_ = 0;
  std::uint64_t includes_ = 0;
  std::uint64_t replayed_ = 0;
  bool full_ = false;
};

// Three words of which the second is a type, or a command.
bool sniff(std::string_view head) {
  Words words(head);
  if (words.at_end()) return false;
  if (words.at_command()) return words.command().starts_with("xform ");
  const std::string_view modifier = words.next(), type = words.next(), identifier = words.next();
  if (modifier.empty() || identifier.empty()) return false;
  const bool known = is_surface(type) || is_material(type) || is_pattern(type);
  if (type == "alias") return modifier == "void";
  const auto strings = parse_integer(words.next());
  return known && strings && *strings >= 0;
}

ReadResult read(const Input& input) { return RadReader(input).run(); }

}  // namespace
}  // namespace radiance

const Reader rad_reader{"rad", radiance::kSuffixes, radiance::sniff, radiance::read};

}  // namespace rad::readers
