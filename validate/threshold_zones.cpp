#include "validate/threshold_zones.h"

#include <algorithm>
#include <utility>

namespace rad::validate {

ThresholdZones::ThresholdZones(const Rule& rule, const LintOptions& options, const scene::Scene& scene)
    : rule_(rule), options_(options), scene_(scene), values_{options.parameters} {
  for (const NamedThreshold& threshold : options.named_thresholds) {
    if (threshold.rule != &rule) continue;
    entries_.push_back(&threshold);
    named_.emplace_back(threshold.names, scene);
  }
  if (!entries_.empty()) find_values();
}

std::size_t ThresholdZones::zone_of(const Violation& violation) const {
  if (values_.size() == 1) return 0;
  Entries all(entries_.size());
  for (const FaceId face : violation.faces) {
    if (face == kNoFace) continue;
    const Entries some = entries_of(scene_.faces[face]);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = all[i] || some[i];
  }
  return static_cast<std::size_t>(std::ranges::find(values_, values_under(all)) - values_.begin());
}

ThresholdZones::Entries ThresholdZones::entries_of(const scene::Face& face) const {
  Entries entries(entries_.size());
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = named_[i].has(face);
  return entries;
}

ParameterValues ThresholdZones::values_under(const Entries& entries) const {
  ParameterValues values = options_.parameters;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i]) values.set(rule_, entries_[i]->parameter, entries_[i]->value);
  }
  return values;
}

// Two faces at most take part in a violation.
void ThresholdZones::find_values() {
  std::set<std::pair<scene::ObjectId, scene::MaterialId>> owners;
  std::set<Entries> alone;
  for (const scene::Face& face : scene_.faces) {
    if (owners.emplace(face.object, face.material).second) alone.insert(entries_of(face));
  }
  for (const Entries& a : alone) {
    for (const Entries& b : alone) {
      Entries both = a;
      for (std::size_t i = 0; i < both.size(); ++i) both[i] = both[i] || b[i];
      ParameterValues values = values_under(both);
      if (std::ranges::find(values_, values) == values_.end()) values_.push_back(std::move(values));
    }
  }
}

}  // namespace rad::validate
