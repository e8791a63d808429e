// PLY of Stanford, as text and in both binary encodings.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "readers/ply_header.h"
#include "readers/ply_values.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader ply_reader;

namespace {

using scene::ReadIssueKind;

constexpr std::array<std::string_view, 1> kSuffixes = {".ply"};
constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
/// What a value of a vertex may be, as a place in the values of a VertexRecord.
constexpr std::size_t kNormal = 3, kTexture = 6, kOther = 8;
constexpr std::array<std::string_view, kTexture> kPlaceNames = {"x", "y", "z", "nx", "ny", "nz"};
/// Texture coordinates have no standard names; these are in use.
constexpr std::array<std::array<std::string_view, 2>, 4> kTextureNames = {
    {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};
using VertexRecord = std::array<double, kOther + 1>;

bool is_index_list(const PlyProperty& property) {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Place of each property of a vertex; kOther for what is passed over.
std::vector<std::size_t> places_of(const PlyElement& element) {
  std::vector<std::size_t> places;
  for (const PlyProperty& property : element.properties) {
    std::size_t place = kOther;
    if (!property.count_type) {
      const auto known = std::ranges::find(kPlaceNames, property.name);
      if (known != kPlaceNames.end()) place = static_cast<std::size_t>(known - kPlaceNames.begin());
      for (const auto& names : kTextureNames) {
        const auto name = std::ranges::find(names, property.name);
        if (name != names.end()) place = kTexture + static_cast<std::size_t>(name - names.begin());
      }
    }
    places.push_back(place);
  }
  return places;
}

bool holds_all(std::span<const std::size_t> places, std::size_t first, std::size_t count) {
  for (std::size_t place = first; place < first + count; ++place) {
    if (std::ranges::find(places, place) == places.end()) return false;
  }
  return true;
}

std::optional<std::int64_t> whole(double value) {
  // Beyond 2^53 doubles no longer hold every integer; no index is that large.
  if (!(std::abs(value) <= 0x1p53) || value != std::floor(value)) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

/// How reading an element ended.
enum class Progress : std::uint8_t { Done, FileEnded, LimitReached };

template <typename Values>
class PlyBody {
 public:
  PlyBody(const Input& input, const PlyHeader& header, Values values, scene::SceneBuilder& builder,
          scene::ReadIssues& issues)
      : input_(input), header_(header), values_(std::move(values)), builder_(builder), issues_(issues) {}

  /// Reads all elements. Faces that stand before the vertices are stepped over and read last.
  void run() {
    std::optional<Values> faces_before_vertices;
    const PlyElement* faces = nullptr;
    bool vertices_read = false;
    Progress progress = Progress::Done;
    for (const PlyElement& element : header_.elements) {
      if (progress != Progress::Done) break;
      if (element.properties.empty()) continue;
      check_count(element);
      if (element.name == "vertex") {
        progress = read_vertices(element);
        vertices_read = true;
      } else if (element.name == "face" && vertices_read) {
        progress = read_faces(element);
      } else {
        if (element.name == "face") {
          faces_before_vertices = values_;
          faces = &element;
        }
        progress = step_over(element);
      }
    }
    if (progress == Progress::Done) report_remainder();
    if (faces == nullptr || progress == Progress::LimitReached) return;
    values_ = *faces_before_vertices;
    read_faces(*faces);
  }

 private:
  // Says at once that a count cannot be true; what is there is read all the same.
  void check_count(const PlyElement& element) {
    std::uint64_t least = 0;
    for (const PlyProperty& property : element.properties) least += Values::least_bytes(property);
    // The last line of a text may lack its end.
    const std::uint64_t room = (values_.bytes_left() + 1) / least;
    if (element.count <= room) return;
    announced_ = &element;
    issues_.add(issue_at_line(ReadIssueKind::ParseError,
                              "the header states " + std::to_string(element.count) + " of " + in_quotes(element.name) +
                                  ", the bytes that follow hold at most " + std::to_string(room),
                              element.line));
  }

  Progress read_vertices(const PlyElement& element) {
    if (element.count > input_.limits.vertices) {
      return stop("the header states " + std::to_string(element.count) + " vertices, the limit is " +
                  std::to_string(input_.limits.vertices));
    }
    const std::vector<std::size_t> places = places_of(element);
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      if (holds_all(places, axis, 1) || element.count == 0) continue;
      return stop("the vertices have no property " + in_quotes(kAxes[axis]));
    }
    has_normals_ = holds_all(places, kNormal, 3);
    has_texture_coordinates_ = holds_all(places, kTexture, 2);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!values_.next_record()) return end_early(element, i);
      if (!read_vertex(element, places)) return end_early(element, i);
    }
    return Progress::Done;
  }

  // False where a binary file ends within the vertex.
  bool read_vertex(const PlyElement& element, const std::vector<std::size_t>& places) {
    VertexRecord record;
    record.fill(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const PlyValue value = property.count_type ? skip_list(property) : values_.read(property.type, record[places[i]]);
      if (value == PlyValue::Ended && !Values::kRecordsAreLines) return false;
      if (value == PlyValue::Good) continue;
      refuse(value == PlyValue::Bad ? "the value of " + in_quotes(property.name) + " is not a number"
                                    : "the value of " + in_quotes(property.name) + " is missing");
      if (value == PlyValue::Ended) break;
    }
    builder_.add_vertex({record[0], record[1], record[2]}, values_.record());
    // One row for each vertex: rows are the ids of vertices.
    if (has_normals_) builder_.add_normal({record[kNormal], record[kNormal + 1], record[kNormal + 2]});
    if (has_texture_coordinates_) builder_.add_texture_coordinates({record[kTexture], record[kTexture + 1]});
    return true;
  }

  Progress read_faces(const PlyElement& element) {
    const auto list = std::ranges::find_if(element.properties, is_index_list);
    if (list == element.properties.end() && element.count > 0) {
      return stop("the faces have no list 'vertex_indices'");
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!values_.next_record()) return end_early(element, i);
      const PlyValue value = read_face(element, *list);
      if (value == PlyValue::Ended && !Values::kRecordsAreLines) return end_early(element, i);
      if (value != PlyValue::Good) {
        refuse("a face is not of the form that the header states; it is left out");
      } else if (!add_face()) {
        return Progress::LimitReached;
      }
    }
    return Progress::Done;
  }

  PlyValue read_face(const PlyElement& element, const PlyProperty& list) {
    indices_.clear();
    PlyValue worst = PlyValue::Good;
    for (const PlyProperty& property : element.properties) {
      PlyValue value = PlyValue::Good;
      if (&property == &list) {
        value = read_indices(property);
      } else {
        value = property.count_type ? skip_list(property) : values_.skip(property.type, 1);
      }
      worst = std::max(worst, value);
      // In a text, a fault ends the line; the next face starts on a new one.
      if (worst == PlyValue::Ended || (worst == PlyValue::Bad && Values::kRecordsAreLines)) return worst;
    }
    return worst;
  }

  PlyValue read_indices(const PlyProperty& list) {
    double count = 0;
    const PlyValue value = values_.read(*list.count_type, count);
    if (value != PlyValue::Good) return value;
    const auto corners = whole(count);
    if (!corners || *corners < 0) return PlyValue::Bad;
    if (static_cast<std::uint64_t>(*corners) > input_.limits.face_corners) {
      const PlyValue skipped = values_.skip(list.type, static_cast<std::uint64_t>(*corners));
      return std::max(skipped, PlyValue::Bad);
    }
    for (std::int64_t i = 0; i < *corners; ++i) {
      double index = 0;
      const PlyValue read = values_.read(list.type, index);
      if (read != PlyValue::Good) return read;
      indices_.push_back(index);
    }
    return PlyValue::Good;
  }

  // False where a limit is reached.
  bool add_face() {
    if (indices_.empty()) {
      refuse("a face names no vertex; it is left out");
      return true;
    }
    corners_.clear();
    for (const double value : indices_) {
      const auto index = whole(value);
      if (!index || *index < 0 || static_cast<std::uint64_t>(*index) >= builder_.vertex_count()) {
        const std::string what = index ? index_outside(*index, builder_.vertex_count())
                                       : std::string("a vertex index is not a whole number");
        issues_.add({ReadIssueKind::IndexOutOfRange, what, values_.place(), 1});
        return true;
      }
      corners_.push_back(static_cast<scene::VertexId>(*index));
    }
    std::string full = limit_before_face(builder_.scene(), corners_.size(), input_.limits);
    if (!full.empty()) {
      refuse(std::move(full));
      return false;
    }
    builder_.add_face(corners_, values_.record());
    if (has_normals_) builder_.set_normals(corners_);
    if (has_texture_coordinates_) builder_.set_texture_coordinates(corners_);
    return true;
  }

  PlyValue skip_list(const PlyProperty& list) {
    double count = 0;
    const PlyValue value = values_.read(*list.count_type, count);
    if (value != PlyValue::Good) return value;
    const auto length = whole(count);
    if (!length || *length < 0) return PlyValue::Bad;
    return values_.skip(list.type, static_cast<std::uint64_t>(*length));
  }

  Progress step_over(const PlyElement& element) {
    if (element.count > 0) report_unsupported(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!values_.next_record()) return end_early(element, i);
      if (Values::kRecordsAreLines) continue;
      for (const PlyProperty& property : element.properties) {
        const PlyValue value = property.count_type ? skip_list(property) : values_.skip(property.type, 1);
        if (value == PlyValue::Ended) return end_early(element, i);
      }
    }
    return Progress::Done;
  }

  void report_unsupported(const PlyElement& element) {
    scene::IssuePlace place;
    place.line = element.line;
    if (element.name == "tristrips") issues_.add_unsupported("triangle strips (tristrips)", place);
    if (element.name == "edge") issues_.add_unsupported("edges", place);
  }

  void report_remainder() {
    if (Values::kRecordsAreLines && values_.next_record()) {
      refuse("lines follow the last element that the header states; they are left out");
    }
  }

  Progress end_early(const PlyElement& element, std::uint64_t read) {
    if (values_.passed_line_limit()) {
      return stop("a line is longer than the limit of " + std::to_string(input_.limits.line_bytes) +
                  " bytes; the rest is left out");
    }
    if (announced_ != &element) {
      refuse("the file ends after " + std::to_string(read) + " of " + std::to_string(element.count) + " of " +
             in_quotes(element.name));
    }
    return Progress::FileEnded;
  }

  Progress stop(std::string what) {
    refuse(std::move(what));
    return Progress::LimitReached;
  }

  void refuse(std::string what) { issues_.add({ReadIssueKind::ParseError, std::move(what), values_.place(), 1}); }

  const Input& input_;
  const PlyHeader& header_;
  Values values_;
  scene::SceneBuilder& builder_;
  scene::ReadIssues& issues_;
  const PlyElement* announced_ = nullptr;
  std::vector<double> indices_;
  std::vector<scene::VertexId> corners_;
  bool has_normals_ = false;
  bool has_texture_coordinates_ = false;
};

bool has_single_precision(const PlyHeader& header) {
  const auto vertices = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  if (vertices == header.elements.end()) return false;
  return std::ranges::all_of(kAxes, [&](std::string_view axis) {
    const PlyProperty* const property = vertices->property(axis);
    return property != nullptr && property->type == PlyType::Float32;
  });
}

void read_body(const Input& input, const PlyHeader& header, scene::SceneBuilder& builder, scene::ReadIssues& issues) {
  switch (header.encoding) {
    case PlyEncoding::Text:
      return PlyBody(input, header, PlyText(header), builder, issues).run();
    case PlyEncoding::LittleEndian: {
      const PlyBinary<std::endian::little> values(input.bytes, header.body_offset);
      return PlyBody(input, header, values, builder, issues).run();
    }
    case PlyEncoding::BigEndian: {
      const PlyBinary<std::endian::big> values(input.bytes, header.body_offset);
      return PlyBody(input, header, values, builder, issues).run();
    }
  }
}

bool sniff(std::string_view head) { return head.starts_with("ply\n") || head.starts_with("ply\r"); }

ReadResult read(const Input& input) {
  ReadResult result;
  scene::SceneBuilder builder(input.path, "ply");
  auto header = read_ply_header(input.bytes, input.limits, result.issues);
  const bool is_text = !header || header->encoding == PlyEncoding::Text;
  builder.add_section({input.path, {}, is_text ? scene::RecordKind::Line : scene::RecordKind::ByteOffset});
  if (header) read_body(input, *header, builder, result.issues);
  result.scene = builder.take();
  if (header) header->comments.apply(result.scene);
  if (header) result.waivers = std::move(header->waivers);
  result.scene.splits_vertices = !result.scene.attributes.empty();
  result.scene.single_precision = header && has_single_precision(*header);
  return result;
}

}  // namespace

const Reader ply_reader{"ply", kSuffixes, sniff, read};

}  // namespace rad::readers
