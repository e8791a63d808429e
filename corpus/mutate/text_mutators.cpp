// Defects that only the text of an OBJ can have.
#include <array>

#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

using Lines = std::vector<std::string>;

Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::vector<std::size_t> lines_that_start(const Lines& lines, std::string_view keyword) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].starts_with(keyword)) found.push_back(i);
  }
  return found;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words(1);
  for (const char c : line) {
    if (c == ' ') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

std::string sentence(const std::vector<std::string>& words) {
  std::string line = words[0];
  for (std::size_t i = 1; i < words.size(); ++i) line += " " + words[i];
  return line;
}

TextMutant at_line(const Lines& lines, std::size_t index) { return {joined(lines), {{}, {}, {index + 1}}}; }

// A random line of the keyword, and a random word of it after the first.
std::optional<TextMutant> with_word(std::string_view obj, Random& random, std::string_view keyword,
                                    const std::string& word) {
  Lines lines = lines_of(obj);
  const auto candidates = lines_that_start(lines, keyword);
  if (candidates.empty()) return std::nullopt;
  const std::size_t index = candidates[random.index(candidates.size())];
  std::vector<std::string> words = words_of(lines[index]);
  words[1 + random.index(words.size() - 1)] = word;
  lines[index] = sentence(words);
  return at_line(lines, index);
}

std::optional<TextMutant> index_out_of_range(std::string_view obj, Random& random) {
  return with_word(obj, random, "f ", "123456789");
}

std::optional<TextMutant> index_zero(std::string_view obj, Random& random) { return with_word(obj, random, "f ", "0"); }

std::optional<TextMutant> not_a_number(std::string_view obj, Random& random) {
  return with_word(obj, random, "v ", random.index(2) == 0 ? "nan" : "-inf");
}

std::optional<TextMutant> no_number(std::string_view obj, Random& random) {
  return with_word(obj, random, "v ", random.index(2) == 0 ? "1,5" : "?");
}

std::optional<TextMutant> missing_mtl(std::string_view obj, Random& random) {
  return with_word(obj, random, "mtllib ", "not_there.mtl");
}

// A record that is no surface, somewhere among the faces.
std::optional<TextMutant> line_record(std::string_view obj, Random& random) {
  Lines lines = lines_of(obj);
  const auto faces = lines_that_start(lines, "f ");
  if (faces.empty()) return std::nullopt;
  const std::size_t index = faces[random.index(faces.size())];
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(index), random.index(2) == 0 ? "l 1 2" : "p 1");
  return at_line(lines, index);
}

constexpr std::array<std::string_view, 1> kNotFinite{"RL003"};

}  // namespace

std::span<const TextMutator> text_mutators() {
  static constexpr std::array<TextMutator, 6> kMutators{{
      {"coordinate that is no number", "RL001", kNotFinite, no_number},
      {"vertex index beyond the last", "RL002", {}, index_out_of_range},
      {"vertex index 0", "RL002", {}, index_zero},
      {"coordinate not finite", "RL003", {}, not_a_number},
      {"mtllib that is not there", "RL006", {}, missing_mtl},
      {"line or point record", "RL010", {}, line_record},
  }};
  return kMutators;
}

}  // namespace rad::corpus
