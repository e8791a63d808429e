#include "config/sidecar.h"

#include <array>
#include <filesystem>

#include "config/fault.h"
#include "config/toml_tree.h"

namespace rad::config {

namespace {

constexpr std::array<Key<scene::Waiver>, 4> kKeys = {{
    {{"rules", "ids, beginnings of ids or names of rules that are not reported"},
     [](const Entry& entry, scene::Waiver& into) { into.rules = entry.texts(); }},
    {{"objects", "globs of names of objects; without it and materials the whole model is meant"},
     [](const Entry& entry, scene::Waiver& into) { into.names.objects = entry.texts(); }},
    {{"materials", "globs of names of materials"},
     [](const Entry& entry, scene::Waiver& into) { into.names.materials = entry.texts(); }},
    {{"reason", "why, for reports"}, [](const Entry& entry, scene::Waiver& into) { into.reason = entry.text(); }},
}};

using Waivers = std::vector<scene::Waiver>;

void read_suppress(const Entry& entry, Waivers& into) {
  for (const Value& table : entry.tables()) {
    scene::Waiver& waiver = into.emplace_back();
    TableReader(table, entry.file, "[[suppress]]").read<scene::Waiver>(kKeys, waiver).refuse_others();
    if (waiver.rules.empty()) throw ConfigFault(entry.file, table.line, "[[suppress]] names no rules");
    waiver.origin = scene::WaiverOrigin::Sidecar;
    waiver.place.file = entry.file;
    waiver.place.line = table.line;
    waiver.scope = waiver.names.empty() ? scene::WaiverScope::File : scene::WaiverScope::Names;
  }
}

constexpr std::array<Key<Waivers>, 1> kTopKeys = {{
    {{"suppress", "what is not to be reported: [[suppress]]"}, &read_suppress},
}};

}  // namespace

std::string sidecar_path(const std::string& model) { return model + ".radlint.toml"; }

std::vector<scene::Waiver> read_sidecar(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  try {
    Waivers waivers;
    const Value top = parse_toml(read_text(path, path), path);
    TableReader(top, path, "").read<Waivers>(kTopKeys, waivers).refuse_others();
    return waivers;
  } catch (const ConfigFault& fault) {
    scene::Waiver waiver;
    waiver.fault = fault.clause();
    waiver.origin = scene::WaiverOrigin::Sidecar;
    waiver.place.file = path;
    waiver.place.line = fault.line();
    return {waiver};
  }
}

std::vector<KeyText> sidecar_keys() {
  std::vector<KeyText> texts;
  for (const Key<scene::Waiver>& key : kKeys) texts.push_back(key.text);
  return texts;
}

}  // namespace rad::config
