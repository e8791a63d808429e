#include "readers/obj_libraries.h"

#include <algorithm>
#include <utility>

#include "readers/companion_path.h"
#include "readers/file_bytes.h"
#include "readers/mtl.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"

namespace rad::readers {
namespace {

constexpr std::string_view kSuffix = ".mtl";
constexpr std::string_view kBlanks = " \t";
constexpr std::size_t kMostLibraries = 1000;

bool is_suffix(std::string_view text) {
  return text.size() == kSuffix.size() && text[0] == '.' && (text[1] | 0x20) == 'm' && (text[2] | 0x20) == 't' &&
         (text[3] | 0x20) == 'l';
}

// Length of the name that the text starts with, up to its ".mtl"; 0 where there is none.
std::size_t name_length(std::string_view text) {
  for (std::size_t last = kSuffix.size(); last <= text.size(); ++last) {
    const bool ends = last == text.size() || kBlanks.find(text[last]) != std::string_view::npos;
    if (ends && is_suffix(text.substr(last - kSuffix.size(), kSuffix.size()))) return last;
  }
  return 0;
}

// The folder part of a library's name, with its last slash; empty for a library beside the model.
std::string_view folder_of(std::string_view name) { return name.substr(0, name.find_last_of("/\\") + 1); }

// Names in a library are relative to it, those in a scene to the model.
void move_below(std::string_view folder, scene::Texture& texture) {
  const std::string& path = texture.image->path;
  const bool is_relative = path.find(':') == std::string::npos && path.front() != '/' && path.front() != '\\';
  if (folder.empty() || !is_relative) return;
  scene::Image moved = *texture.image;
  moved.path.insert(0, folder);
  texture.image = std::make_shared<scene::Image>(std::move(moved));
}

}  // namespace

std::vector<std::string> library_names(std::string_view statement) {
  std::vector<std::string> names;
  bool has_suffix = true;
  while (true) {
    const std::size_t first = statement.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return names;
    statement.remove_prefix(first);
    std::size_t length = has_suffix ? name_length(statement) : 0;
    has_suffix = length > 0;
    if (!has_suffix) length = std::min(statement.find_first_of(kBlanks), statement.size());
    names.emplace_back(statement.substr(0, length));
    statement.remove_prefix(length);
  }
}

void ObjLibraries::use(std::string_view statement, std::uint64_t line) {
  for (const std::string& name : library_names(statement)) {
    if (seen_.size() > kMostLibraries || !seen_.insert(name).second) continue;
    if (seen_.size() <= kMostLibraries) {
      read(name, line);
    } else {
      add_missing("more than " + std::to_string(kMostLibraries) + " material libraries are named; the rest is left out",
                  line);
    }
  }
}

void ObjLibraries::read(const std::string& name, std::uint64_t line) {
  const auto path = companion_path(input_.directory, name);
  if (!path) {
    add_missing("material library " + in_quotes(name) + " lies outside the model's folder", line);
    return;
  }
  if (input_.companions != nullptr) input_.companions->push_back(*path);
  FileBytes file;
  const std::string problem = file.open(*path, input_.limits.file_bytes, FileKind::Regular);
  if (!problem.empty()) {
    add_missing("material library " + in_quotes(name) + " cannot be read: " + problem, line);
    return;
  }
  for (scene::Material& material : read_mtl(file.bytes(), path->string(), issues_)) {
    if (material.texture) move_below(folder_of(name), *material.texture);
    define(std::move(material));
  }
}

void ObjLibraries::define(scene::Material material) {
  const scene::MaterialId id = builder_.material(material.name);
  if (defined_.insert(id).second) builder_.material_at(id) = std::move(material);
}

void ObjLibraries::add_missing(std::string what, std::uint64_t line) {
  issues_.add(issue_at_line(scene::ReadIssueKind::MissingResource, std::move(what), line));
}

}  // namespace rad::readers
