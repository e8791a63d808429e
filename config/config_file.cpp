#include "config/config_file.h"

#include <algorithm>
#include <array>

#include "config/file_keys.h"
#include "config/settings_keys.h"
#include "config/words.h"

namespace rad::config {

namespace {

namespace fs = std::filesystem;

template <typename Value>
Stated<Value> stated(const Entry& entry, Choices<Value> choices) {
  Stated<Value> result{Value{}, entry.origin()};
  if (const std::string fault = choose<Value>(entry.text(), choices, result.value); !fault.empty()) entry.fail(fault);
  return result;
}

std::vector<PathPattern> patterns_of(const Entry& entry, const ConfigFile& of) {
  std::vector<PathPattern> patterns;
  for (std::string& glob : entry.texts()) patterns.push_back({std::move(glob), of.path.parent_path()});
  return patterns;
}

struct FilesTable {
  FilesEntry entry;
  const ConfigFile& of;
};

constexpr std::array<Key<FilesTable>, 1> kFilesKeys = {{
    {{"files", "globs of paths below the folder of the file"},
     [](const Entry& entry, FilesTable& into) { into.entry.files = patterns_of(entry, into.of); }},
}};

constexpr std::array<Key<ObjectsEntry>, 5> kObjectsKeys = {{
    {{"objects", "globs of names of objects"},
     [](const Entry& entry, ObjectsEntry& into) { into.names.objects = entry.texts(); }},
    {{"materials", "globs of names of materials"},
     [](const Entry& entry, ObjectsEntry& into) { into.names.materials = entry.texts(); }},
    {{"ignore", "rules that are not reported there; what they find is counted as suppressed"},
     [](const Entry& entry, ObjectsEntry& into) { into.ignore = selectors_of(entry); }},
    {{"rules", "severities and thresholds there: { RL240 = \"note\", RL212 = { max-gap = 5 } }"},
     [](const Entry& entry, ObjectsEntry& into) {
       for (const auto& [rule, settings] : rules_in(entry)) {
         if (settings.severity && settings.severity->value) {
           into.severities[rule] = *settings.severity->value;
         } else if (settings.severity) {
           into.ignore.emplace_back(rule->id);
         }
         for (const auto& [name, value] : settings.parameters) into.thresholds[rule][name] = value.value;
       }
     }},
    {{"reason", "why, for reports"}, [](const Entry& entry, ObjectsEntry& into) { into.reason = entry.text(); }},
}};

void read_files(const Entry& entry, ConfigFile& into) {
  for (const Value& table : entry.tables()) {
    FilesTable read{{{}, {}, {into.shown, table.line}}, into};
    TableReader reader(table, into.shown, "[[files]]");
    reader.read<FilesTable>(kFilesKeys, read).read(settings_keys(), read.entry.settings).refuse_others();
    if (read.entry.files.empty()) throw ConfigFault(into.shown, table.line, "[[files]] names no files");
    into.files.push_back(std::move(read.entry));
  }
}

void read_objects(const Entry& entry, ConfigFile& into) {
  for (const Value& table : entry.tables()) {
    ObjectsEntry read;
    read.origin = {into.shown, table.line};
    TableReader(table, into.shown, "[[objects]]").read<ObjectsEntry>(kObjectsKeys, read).refuse_others();
    if (read.names.empty()) throw ConfigFault(into.shown, table.line, "[[objects]] names no objects or materials");
    into.objects.push_back(std::move(read));
  }
}

constexpr std::array<Key<ConfigFile>, 6> kTopKeys = {{
    {{"extend", "files that this one builds on, relative to it; what it says itself comes later and wins"},
     [](const Entry& entry, ConfigFile& into) {
       for (std::string& path : entry.texts()) into.extends.push_back({std::move(path), entry.origin()});
     }},
    {{"stage", "what models are held to: model, preprocess, solve, display"},
     [](const Entry& entry, ConfigFile& into) { into.stage = stated<validate::Stage>(entry, kStages); }},
    {{"fail-on", "the least severity that makes the run fail: error, warning, note, never"},
     [](const Entry& entry, ConfigFile& into) { into.fail_on = stated<report::FailOn>(entry, kFailOn); }},
    {{"exclude", "globs of files and folders that are passed over in folders"},
     [](const Entry& entry, ConfigFile& into) {
       for (PathPattern& pattern : patterns_of(entry, into)) {
         into.exclude.push_back({std::move(pattern), entry.origin()});
       }
     }},
    {{"files", "settings for some models: [[files]]"}, &read_files},
    {{"objects", "settings for faces by the names of their objects and materials: [[objects]]"}, &read_objects},
}};

template <typename Target>
void add_texts(std::span<const Key<Target>> keys, std::vector<KeyText>& into) {
  for (const Key<Target>& key : keys) into.push_back(key.text);
}

}  // namespace

bool FilesEntry::fits(const fs::path& model) const {
  return std::ranges::any_of(files, [&](const PathPattern& pattern) { return pattern.covers(model); });
}

std::vector<KeyText> keys_of(ConfigTable table) {
  std::vector<KeyText> texts;
  switch (table) {
    case ConfigTable::Top:
      add_texts<ConfigFile>(kTopKeys, texts);
      add_texts(settings_keys(), texts);
      break;
    case ConfigTable::Files:
      add_texts<FilesTable>(kFilesKeys, texts);
      add_texts(settings_keys(), texts);
      break;
    case ConfigTable::Objects:
      add_texts<ObjectsEntry>(kObjectsKeys, texts);
      break;
  }
  return texts;
}

std::string shown_path(const fs::path& path) {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  const fs::path relative = error ? fs::path() : path.lexically_relative(here);
  return (relative.empty() ? path : relative).generic_string();
}

ConfigFile config_of(std::string_view text, const fs::path& path, const std::string& shown) {
  ConfigFile file;
  file.path = path;
  file.shown = shown;
  const Value top = parse_toml(text, shown);
  TableReader(top, file.shown, "")
      .read<ConfigFile>(kTopKeys, file)
      .read(settings_keys(), file.settings)
      .refuse_others();
  return file;
}

ConfigFile read_config_file(const fs::path& path) {
  const std::string shown = shown_path(path);
  return config_of(read_text(path.string(), shown), path, shown);
}

}  // namespace rad::config
