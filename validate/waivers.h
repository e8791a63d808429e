// Which violations an author asks not to be told of, and which of these wishes come to nothing.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "validate/lint.h"
#include "validate/violation.h"

namespace rad::validate {

/// The waivers of a model, in order; of several that speak of a violation the first counts. A violation is silenced
/// where one of the faces that take part is covered; one without faces by a waiver of the whole file, or of the records
/// that its vertex is among.
class Waivers {
 public:
  Waivers(std::span<const scene::Waiver> waivers, const scene::Scene& scene);

  /// Whether one of them may silence the rule.
  [[nodiscard]] bool speak_of(const Rule& rule) const { return of_rule_.contains(&rule); }

  /// The waiver that silences this; nothing where none does. Notes that it is of use.
  std::optional<std::size_t> silencing(const Rule& rule, const Violation& violation);
  std::optional<std::size_t> silencing(const Rule& rule, const scene::ReadIssue& issue);

  /// RL905 for what cannot be understood; with `all_judged` also RL903 for every rule named in the model or beside it
  /// that silences nothing although it was checked. In the order of the waivers.
  [[nodiscard]] std::vector<scene::Finding> complaints(const LintOptions& options, std::span<const Rule* const> checked,
                                                       bool all_judged) const;

  /// A use of waiver `index` that has silenced nothing yet.
  [[nodiscard]] SuppressionUse use_of(std::size_t index) const;

 private:
  /// One rule named by one waiver, with the rules that it stands for.
  struct Entry {
    std::size_t waiver = 0;
    std::string_view selector;
    std::vector<const Rule*> rules;
    bool used = false;
  };

  template <typename Covers>
  std::optional<std::size_t> first_of(const Rule& rule, Covers covers);
  [[nodiscard]] bool covers_face(std::size_t waiver, scene::FaceId face) const;
  [[nodiscard]] bool covers_violation(std::size_t waiver, const Violation& violation) const;
  [[nodiscard]] bool covers_issue(std::size_t waiver, const scene::ReadIssue& issue) const;
  [[nodiscard]] scene::Where place_of(const scene::Waiver& waiver) const;

  std::span<const scene::Waiver> waivers_;
  const scene::Scene& scene_;
  std::vector<std::optional<scene::NamedFaces>> named_;  ///< per waiver; nothing but for scope Names
  std::vector<Entry> entries_;
  std::map<const Rule*, std::vector<std::size_t>> of_rule_;  ///< entries, ascending
};

}  // namespace rad::validate
