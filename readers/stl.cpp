// STL: which of the two kinds a file is.
#include <algorithm>
#include <array>
#include <string>

#include "readers/reader.h"
#include "readers/stl_binary.h"
#include "readers/stl_text.h"
#include "readers/text_cursor.h"

namespace rad::readers {

extern const Reader stl_reader;

namespace {

constexpr std::array<std::string_view, 1> kSuffixes = {".stl"};

std::string first_word_in_lower_case(std::string_view bytes) {
  TextCursor cursor(bytes.substr(0, kSniffBytes));
  std::string word;
  while (word.empty() && cursor.next_line()) word = cursor.next_token();
  std::ranges::transform(word, word.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return word;
}

bool starts_as_text(std::string_view bytes) {
  const std::string word = first_word_in_lower_case(bytes);
  return (word == "solid" || word == "facet") && bytes.substr(0, kSniffBytes).find('\0') == std::string_view::npos;
}

// The size decides first: many binary files begin with "solid" as well.
bool is_binary(std::string_view bytes) {
  if (bytes.size() >= kStlHeaderBytes && bytes.size() == kStlHeaderBytes + kStlFacetBytes * stated_stl_facets(bytes)) {
    return true;
  }
  return !starts_as_text(bytes);
}

bool sniff(std::string_view head) {
  if (!starts_as_text(head)) return false;
  TextCursor cursor(head);
  while (cursor.next_line()) {
    const std::string_view word = cursor.next_token();
    if (word == "facet" || word == "FACET" || word == "endsolid" || word == "ENDSOLID") return true;
  }
  return false;
}

ReadResult read(const Input& input) {
  ReadResult result = is_binary(input.bytes) ? read_binary_stl(input) : read_text_stl(input);
  result.scene.single_precision = true;
  result.scene.triangles_only = true;
  result.scene.splits_vertices = true;
  return result;
}

}  // namespace

const Reader stl_reader{"stl", kSuffixes, sniff, read};

}  // namespace rad::readers
