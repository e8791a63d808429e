// The readers in order, and the way from a path to one of them.
#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "readers/components.h"
#include "readers/file_bytes.h"
#include "readers/reader.h"
#include "readers/text_cursor.h"
#include "readers/unread_formats.h"

namespace rad::readers {

extern const Reader cityjson_reader;
extern const Reader drc_reader;
extern const Reader dxf_reader;
extern const Reader gltf_reader;
extern const Reader hbjson_reader;
extern const Reader ies_reader;
extern const Reader ldt_reader;
extern const Reader obj_reader;
extern const Reader off_reader;
extern const Reader ply_reader;
extern const Reader rad_reader;
extern const Reader stage_reader;
extern const Reader stl_reader;

namespace {

constexpr std::string_view kRemedy = "export OBJ, glTF, PLY, STL or OFF";

// Readers refer to tables of other translation units: they are copied on first use, when those are in place.
std::vector<Reader> make_readers() {
  std::vector<Reader> readers = {stage_reader, gltf_reader, cityjson_reader, hbjson_reader, ply_reader, off_reader,
                                 drc_reader,   dxf_reader,  rad_reader,      ies_reader,    ldt_reader};
  for (const Component& component : components()) {
    if (component.reader != nullptr) readers.push_back(*component.reader);
  }
  readers.push_back(stl_reader);
  readers.push_back(obj_reader);
  return readers;
}

const std::vector<Reader>& readers() {
  static const std::vector<Reader> kReaders = make_readers();
  return kReaders;
}

const Reader* reader_of_content(std::string_view bytes) {
  const std::string_view head = without_byte_order_mark(bytes.substr(0, kSniffBytes));
  const auto found = std::ranges::find_if(readers(), [&](const Reader& reader) { return reader.sniff(head); });
  return found == readers().end() ? nullptr : &*found;
}

const Reader* reader_of_suffix(const std::filesystem::path& path) {
  const std::string name = lower_case_name(path);
  for (const Reader& reader : readers()) {
    if (std::ranges::any_of(reader.suffixes, [&](std::string_view suffix) { return name.ends_with(suffix); })) {
      return &reader;
    }
  }
  return nullptr;
}

bool is_utf16(std::string_view bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

ReadResult unread(const std::string& path, std::string what) {
  ReadResult result;
  result.scene = scene::empty_scene(path, "");
  result.issues.add({scene::ReadIssueKind::ParseError, std::move(what), {}, 1});
  return result;
}

// Why no reader takes these bytes; empty where one does.
std::string refusal(const Input& input, const Reader* by_content, const Reader* by_suffix) {
  if (input.bytes.empty()) return "the file is empty";
  if (by_content != nullptr) return {};
  const bool is_text_format = by_suffix != nullptr && by_suffix->format != "stl" && by_suffix->format != "gltf" &&
                              by_suffix->format != "assimp";
  if (is_utf16(input.bytes) && (by_suffix == nullptr || is_text_format)) {
    return "the text is UTF-16; save the file as UTF-8";
  }
  if (by_suffix != nullptr) return {};
  if (const Component* const component = missing_component(input.path)) {
    return std::string(component->formats) + " are read through " + std::string(component->name) +
           ", which this build is without; " + std::string(kRemedy);
  }
  const std::string_view known = unread_format(input.bytes.substr(0, kSniffBytes), input.path);
  if (!known.empty()) return std::string(known) + " is not read yet; " + std::string(kRemedy);
  return "the format is not known; " + std::string(kRemedy);
}

}  // namespace

std::span<const Reader> all_readers() { return readers(); }

const Reader* find_reader(std::string_view bytes, const std::filesystem::path& path) {
  const Reader* const by_content = reader_of_content(bytes);
  return by_content != nullptr ? by_content : reader_of_suffix(path);
}

ReadResult read_bytes(const Input& input) {
  const Reader* const by_content = reader_of_content(input.bytes);
  const Reader* const by_suffix = reader_of_suffix(input.path);
  const std::string why_not = refusal(input, by_content, by_suffix);
  if (!why_not.empty()) return unread(input.path, why_not);
  return (by_content != nullptr ? by_content : by_suffix)->read(input);
}

ReadResult read_file(const std::filesystem::path& path, const Limits& limits, const Choices& choices) {
  FileBytes file;
  const std::string problem = file.open(path, limits.file_bytes, FileKind::RegularOrStream);
  if (!problem.empty()) return unread(path.string(), "the file cannot be read: " + problem);
  Input input;
  input.path = path.string();
  input.directory = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  input.bytes = file.bytes();
  input.limits = limits;
  input.choices = choices;
  std::vector<std::filesystem::path> companions;
  input.companions = &companions;
  ReadResult result = read_bytes(input);
  result.companions = std::move(companions);
  return result;
}

std::span<const std::string_view> model_suffixes() {
  static const std::vector<std::string_view> kSuffixes = [] {
    std::vector<std::string_view> suffixes;
    for (const Reader& reader : readers()) {
      suffixes.insert(suffixes.end(), reader.suffixes.begin(), reader.suffixes.end());
    }
    std::ranges::sort(suffixes);
    return suffixes;
  }();
  return kSuffixes;
}

}  // namespace rad::readers
