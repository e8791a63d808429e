#include "report/matching.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string_view>

#include "scene/disjoint_sets.h"
#include "validate/rules.h"

namespace rad::report {

namespace {

using geom::dvec3;
using scene::Finding;

constexpr double kNearInTolerances = 64;
constexpr double kSameSpotInTolerances = 16;
constexpr double kLeastOverlap = 0.5;
constexpr std::size_t kPairsTried = 10'000;  // of findings with equal fingerprints

/// What is compared of a finding.
struct Locus {
  geom::Box box;  ///< of all violations; empty where there is no place
  std::optional<dvec3> frame;

  [[nodiscard]] geom::Box local() const {
    return frame && !box.empty() ? geom::Box{box.low - *frame, box.high - *frame} : box;
  }
};

Locus locus_of(const Finding& finding) {
  Locus locus{{}, finding.where.frame};
  if (finding.where.bounds) {
    locus.box = {(*finding.where.bounds)[0], (*finding.where.bounds)[1]};
  } else if (finding.where.point) {
    locus.box = {*finding.where.point, *finding.where.point};
  }
  return locus;
}

// The larger distance of two corners: 0 for equal boxes.
double distance(const geom::Box& a, const geom::Box& b) {
  return std::max(glm::distance(a.low, b.low), glm::distance(a.high, b.high));
}

double distance(const Locus& a, const Locus& b) {
  return std::min(distance(a.box, b.box), a.frame && b.frame ? distance(a.local(), b.local()) : 1e300);
}

geom::Box joined(geom::Box a, const geom::Box& b) {
  a.add(b.low);
  a.add(b.high);
  return a;
}

bool meet(const geom::Box& a, const geom::Box& b, double reach) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.low[axis] > b.high[axis] + reach || b.low[axis] > a.high[axis] + reach) return false;
  }
  return true;
}

bool holds(const geom::Box& outer, const geom::Box& inner, double reach) {
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.low[axis] < outer.low[axis] - reach || inner.high[axis] > outer.high[axis] + reach) return false;
  }
  return true;
}

template <typename Item>
void append(std::vector<Item>& all, std::vector<Item> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// Share of the longer diagonal that is common to both.
double overlap(const geom::Box& a, const geom::Box& b) {
  const double longer = std::max(a.diagonal(), b.diagonal());
  if (!meet(a, b, 0) || longer == 0) return 0;
  const geom::Box common{glm::max(a.low, b.low), glm::min(a.high, b.high)};
  return common.diagonal() / longer;
}

// "0123456789abcdef" of "0123456789abcdef-2": the second of equal ones may be the first of another run.
std::string_view base_of(std::string_view fingerprint) { return fingerprint.substr(0, fingerprint.find('-')); }

bool same_participants(const Finding& a, const Finding& b) {
  return a.where.objects == b.where.objects && a.where.materials == b.where.materials;
}

/// Numbered boxes, to be searched along x.
class BoxList {
 public:
  void add(const geom::Box& box, std::size_t id) {
    entries_.emplace_back(box.low.x, id);
    widest_ = std::max(widest_, box.high.x - box.low.x);
  }
  void sort() { std::sort(entries_.begin(), entries_.end()); }

  /// Every box whose extent in x comes within `reach` of that of `box`, and some others.
  template <typename Visit>
  void near(const geom::Box& box, double reach, Visit visit) const {
    const auto start =
        std::lower_bound(entries_.begin(), entries_.end(), std::pair(box.low.x - reach - widest_, std::size_t{0}));
    for (auto it = start; it != entries_.end() && it->first <= box.high.x + reach; ++it) visit(it->second);
  }

 private:
  std::vector<std::pair<double, std::size_t>> entries_;
  double widest_ = 0;
};

/// A pair that may be one fault. Near ones come first; ties by the order of the findings.
struct Candidate {
  double distance = 0;
  std::size_t old = 0;
  std::size_t now = 0;
  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

/// The findings of one rule.
class RuleMatcher {
 public:
  RuleMatcher(std::vector<const Finding*> old, std::vector<const Finding*> now, const MatchOptions& options)
      : old_(std::move(old)), now_(std::move(now)), options_(options) {
    for (const Finding* finding : old_) old_loci_.push_back(locus_of(*finding));
    for (const Finding* finding : now_) now_loci_.push_back(locus_of(*finding));
    old_taken_.resize(old_.size());
    now_taken_.resize(now_.size());
  }

  void run(Matching& all) {
    Matching out;  // of this rule alone
    match_fingerprints(out);
    const double near = kNearInTolerances * options_.tolerance;
    const double same = kSameSpotInTolerances * options_.tolerance;
    match_near(out, near, [](const Finding& a, const Finding& b) { return same_participants(a, b); });
    match_near(out, same, [](const Finding& a, const Finding& b) { return a.count == b.count; });
    match_groups(out, same);
    match_near(out, same, [](const Finding&, const Finding&) { return true; });
    match_overlapping(out);
    match_placeless(out);
    match_only_ones(out);
    if (options_.regrouped) absorb(out, same);
    for (std::size_t i = 0; i < old_.size(); ++i) {
      if (!old_taken_[i]) out.only_old.push_back(old_[i]);
    }
    for (std::size_t i = 0; i < now_.size(); ++i) {
      if (!now_taken_[i]) out.only_now.push_back(now_[i]);
    }
    append(all.matches, std::move(out.matches));
    append(all.only_old, std::move(out.only_old));
    append(all.only_now, std::move(out.only_now));
  }

 private:
  void take_nearest(Matching& out, std::vector<Candidate> candidates) {
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& candidate : candidates) {
      if (old_taken_[candidate.old] || now_taken_[candidate.now]) continue;
      old_taken_[candidate.old] = now_taken_[candidate.now] = true;
      out.matches.push_back({{old_[candidate.old]}, {now_[candidate.now]}});
    }
  }

  void match_fingerprints(Matching& out) {
    std::map<std::string_view, std::array<std::vector<std::size_t>, 2>> equal;
    for (std::size_t i = 0; i < old_.size(); ++i) equal[base_of(old_[i]->fingerprint)][0].push_back(i);
    for (std::size_t j = 0; j < now_.size(); ++j) equal[base_of(now_[j]->fingerprint)][1].push_back(j);
    std::vector<Candidate> candidates;
    for (const auto& [fingerprint, sides] : equal) {
      if (sides[0].size() * sides[1].size() > kPairsTried) continue;  // near ones are found by their places
      for (const std::size_t i : sides[0]) {
        for (const std::size_t j : sides[1]) {
          const bool placed = !old_loci_[i].box.empty() && !now_loci_[j].box.empty();
          candidates.push_back({placed ? distance(old_loci_[i].box, now_loci_[j].box) : 0, i, j});
        }
      }
    }
    take_nearest(out, std::move(candidates));
  }

  /// Calls visit(old, now) for pairs that are left and have a place, boxes in reach of each other along x; in the model
  /// and then, where `local`, in their frames.
  template <typename Visit>
  void each_pair(double reach, bool local, Visit visit) const {
    for (int pass = 0; pass < (local ? 2 : 1); ++pass) {
      const auto box = [&](const Locus& locus) { return pass == 1 ? locus.local() : locus.box; };
      BoxList known;
      for (std::size_t i = 0; i < old_.size(); ++i) {
        if (!old_taken_[i] && !old_loci_[i].box.empty()) known.add(box(old_loci_[i]), i);
      }
      known.sort();
      for (std::size_t j = 0; j < now_.size(); ++j) {
        if (now_taken_[j] || now_loci_[j].box.empty()) continue;
        known.near(box(now_loci_[j]), reach, [&](std::size_t i) { visit(i, j); });
      }
    }
  }

  template <typename Fits>
  void match_near(Matching& out, double reach, Fits fits) {
    std::vector<Candidate> candidates;
    each_pair(reach, true, [&](std::size_t i, std::size_t j) {
      const double apart = distance(old_loci_[i], now_loci_[j]);
      if (apart <= reach && fits(*old_[i], *now_[j])) candidates.push_back({apart, i, j});
    });
    take_nearest(out, std::move(candidates));
  }

  // What is left on both sides, joined where bounds meet: as many violations in the same bounds are the same ones.
  void match_groups(Matching& out, double reach) {
    const std::size_t total = old_.size() + now_.size();
    scene::DisjointSets sets(total);
    each_pair(reach, false, [&](std::size_t i, std::size_t j) {
      if (!meet(old_loci_[i].box, now_loci_[j].box, reach)) return;
      sets.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(old_.size() + j));
    });
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
    for (std::uint32_t i = 0; i < total; ++i) groups[sets.find(i)].push_back(i);
    for (const auto& [root, members] : groups) {
      if (members.size() > 1) take_group(out, members, reach);
    }
  }

  void take_group(Matching& out, const std::vector<std::uint32_t>& members, double reach) {
    Match match;
    std::array<geom::Box, 2> boxes;
    std::array<std::uint64_t, 2> counts{};
    for (const std::uint32_t i : members) {
      const bool is_old = i < old_.size();
      const Finding* finding = is_old ? old_[i] : now_[i - old_.size()];
      (is_old ? match.old : match.now).push_back(finding);
      boxes[is_old ? 0 : 1] = joined(boxes[is_old ? 0 : 1], (is_old ? old_loci_[i] : now_loci_[i - old_.size()]).box);
      counts[is_old ? 0 : 1] += finding->count;
    }
    if (match.old.empty() || match.now.empty() || distance(boxes[0], boxes[1]) > reach) return;
    if (counts[0] != counts[1] && !options_.regrouped) return;
    for (const std::uint32_t i : members) {
      if (i < old_.size()) {
        old_taken_[i] = true;
      } else {
        now_taken_[i - old_.size()] = true;
      }
    }
    out.matches.push_back(std::move(match));
  }

  void match_overlapping(Matching& out) {
    std::vector<Candidate> candidates;
    each_pair(0, true, [&](std::size_t i, std::size_t j) {
      if (!same_participants(*old_[i], *now_[j])) return;
      const Locus& a = old_loci_[i];
      const Locus& b = now_loci_[j];
      const double common = std::max(overlap(a.box, b.box), overlap(a.local(), b.local()));
      if (common >= kLeastOverlap) candidates.push_back({-common, i, j});
    });
    take_nearest(out, std::move(candidates));
  }

  // In their order: nothing else tells them apart.
  void match_placeless(Matching& out) {
    using Participants = std::pair<std::vector<std::string>, std::vector<std::string>>;
    std::map<Participants, std::vector<std::size_t>> left;
    for (std::size_t i = old_.size(); i-- > 0;) {
      const scene::Where& where = old_[i]->where;
      if (!old_taken_[i] && old_loci_[i].box.empty()) left[{where.objects, where.materials}].push_back(i);
    }
    for (std::size_t j = 0; j < now_.size(); ++j) {
      if (now_taken_[j] || !now_loci_[j].box.empty()) continue;
      const auto found = left.find({now_[j]->where.objects, now_[j]->where.materials});
      if (found == left.end() || found->second.empty()) continue;
      take_nearest(out, {{0, found->second.back(), j}});
      found->second.pop_back();
    }
  }

  // What is left joins the smallest match that holds it.
  void absorb(Matching& out, double reach) {
    const auto join = [&](const Finding& finding, auto other, auto own) {
      Match* best = nullptr;
      double size = 0;
      for (Match& match : out.matches) {
        const geom::Box box = locus_of(*(match.*other).front()).box;
        if (box.empty() || !holds(box, locus_of(finding).box, reach)) continue;
        if (!options_.names_lost && !same_participants(*(match.*other).front(), finding)) continue;
        if (best != nullptr && box.diagonal() >= size) continue;
        best = &match;
        size = box.diagonal();
      }
      if (best != nullptr) (best->*own).push_back(&finding);
      return best != nullptr;
    };
    for (std::size_t i = 0; i < old_.size(); ++i) {
      if (!old_taken_[i] && !old_loci_[i].box.empty()) old_taken_[i] = join(*old_[i], &Match::now, &Match::old);
    }
    for (std::size_t j = 0; j < now_.size(); ++j) {
      if (!now_taken_[j] && !now_loci_[j].box.empty()) now_taken_[j] = join(*now_[j], &Match::old, &Match::now);
    }
  }

  // A finding that stands for several violations, or for the whole model, shows the place of one of them.
  void match_only_ones(Matching& out) {
    using Participants = std::pair<std::vector<std::string>, std::vector<std::string>>;
    std::map<Participants, std::array<std::vector<std::size_t>, 2>> all;
    for (std::size_t i = 0; i < old_.size(); ++i)
      all[{old_[i]->where.objects, old_[i]->where.materials}][0].push_back(i);
    for (std::size_t j = 0; j < now_.size(); ++j)
      all[{now_[j]->where.objects, now_[j]->where.materials}][1].push_back(j);
    for (const auto& [participants, sides] : all) {
      if (sides[0].size() != 1 || sides[1].size() != 1) continue;
      const bool of_model = old_[sides[0][0]]->where.face_count == 0 && now_[sides[1][0]]->where.face_count == 0;
      const bool several = old_[sides[0][0]]->count > 1 && now_[sides[1][0]]->count > 1;
      if (of_model || several) take_nearest(out, {{0, sides[0][0], sides[1][0]}});
    }
  }

  std::vector<const Finding*> old_;
  std::vector<const Finding*> now_;
  MatchOptions options_;
  std::vector<Locus> old_loci_;
  std::vector<Locus> now_loci_;
  std::vector<bool> old_taken_;
  std::vector<bool> now_taken_;
};

using ByRule = std::map<std::string_view, std::array<std::vector<const Finding*>, 2>>;

// What remains of a rule where objects and materials are not known.
std::string_view without_names(std::string_view rule) {
  if (rule == validate::coplanar_overlap_diff.id) return validate::coplanar_overlap_same.id;
  return rule == validate::hidden_coplanar.id ? validate::double_sided_duplicate.id : rule;
}

}  // namespace

Matching match_findings(std::span<const Finding> old, std::span<const Finding> now, const MatchOptions& options) {
  ByRule rules;
  const auto kind = [&](const Finding& finding) {
    return options.names_lost ? without_names(finding.rule) : finding.rule;
  };
  for (const Finding& finding : old) rules[kind(finding)][0].push_back(&finding);
  for (const Finding& finding : now) rules[kind(finding)][1].push_back(&finding);
  Matching matching;
  for (auto& [rule, sides] : rules) {
    RuleMatcher(std::move(sides[0]), std::move(sides[1]), options).run(matching);
  }
  std::ranges::sort(matching.matches, {}, [](const Match& match) { return match.now.front(); });
  std::ranges::sort(matching.only_old);
  std::ranges::sort(matching.only_now);
  return matching;
}

}  // namespace rad::report
