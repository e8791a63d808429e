// Reading a model file into a raw Scene. Readers never merge or repair, and never throw on what a file says.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "readers/choices.h"
#include "readers/limits.h"
#include "scene/read_issue.h"
#include "scene/scene.h"
#include "scene/waiver.h"

namespace rad::readers {

struct ReadResult {
  scene::Scene scene;  ///< what could be read; empty after a fatal ParseError
  scene::ReadIssues issues;
  std::vector<scene::Waiver> waivers{};
  std::vector<std::filesystem::path> companions{};  ///< files beside the model that were looked for, there or not
};

/// The bytes of a file together with where companions (mtllib, buffers) are looked for.
struct Input {
  std::string path;                 ///< for messages
  std::filesystem::path directory;  ///< companions are opened below this folder only
  std::string_view bytes;
  Limits limits;
  std::vector<std::filesystem::path>* companions = nullptr;  ///< gets every companion that is looked for
  Choices choices;
};

/// One format. `sniff` sees the first kSniffBytes and answers whether the content is of this format beyond doubt;
/// `suffixes` (lower case, with dot) decide where content does not.
struct Reader {
  std::string_view format;
  std::span<const std::string_view> suffixes;
  bool (*sniff)(std::string_view head);
  ReadResult (*read)(const Input& input);
};

inline constexpr std::size_t kSniffBytes = 4096;

/// All readers in order of sniffing.
std::span<const Reader> all_readers();

/// The reader for this content: by content first, by suffix where no content rule speaks. Null where neither knows it.
const Reader* find_reader(std::string_view bytes, const std::filesystem::path& path);

/// Reads a file. A path that cannot be opened, an unknown format and a damaged file give a ParseError issue.
ReadResult read_file(const std::filesystem::path& path, const Limits& limits = {}, const Choices& choices = {});

/// Reads bytes that are already in memory, as read_file would read a file of this name.
ReadResult read_bytes(const Input& input);

/// Suffixes that a folder is searched for, lower case, with dot.
std::span<const std::string_view> model_suffixes();

}  // namespace rad::readers
