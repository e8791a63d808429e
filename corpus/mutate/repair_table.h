// What radfix makes of planted defects: whether each is gone, and whether anything else has changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "corpus/mutate/mutator.h"

namespace rad::corpus {

/// What became of a mutator's defects over all models and seeds.
struct RepairScore {
  std::string mutator;
  std::string rule;
  bool repairable = false;  ///< the rule has a safe fix in a model: the defect must go
  std::size_t planted = 0;
  std::size_t gone = 0;     ///< the rule does not speak at the planted place any more
  std::size_t named = 0;    ///< it still does
  std::size_t refused = 0;  ///< nothing was written, with a word
  std::size_t seams = 0;    ///< findings of RL120 in all results
  double lost = 0;          ///< how far the clean model is from the result, outside of the planted place, T
  double added = 0;         ///< how far the result is from the clean model there, T
  double area = 0;          ///< change of area of a material, beyond what was planted, over perimeter times T
  double moved = 0;         ///< the largest movement of the ledger, T
};

struct RepairTable {
  std::vector<RepairScore> scores;    ///< one for each mutator
  std::vector<std::string> failures;  ///< one line for each thing that must not be
};

struct RepairTrials {
  std::filesystem::path radfix;     ///< the program
  std::vector<std::string> models;  ///< of clean_subjects(); empty: all
  std::uint64_t seeds = 1;
};

/// Plants every mutator's defect into clean models, runs radfix on the OBJ of each, reads what it wrote, and judges:
/// a repairable defect is gone and radfix ends with 0; what is not repairable is gone, still named or refused; outside
/// of the planted place the clean model is there within T (and what noise was planted) and nothing else is; areas of
/// materials are those of the clean model up to perimeter times T and what was planted; no other rule speaks than
/// before; the ledger keeps the bounds of docs/repair.md.
RepairTable measure_repairs(const RepairTrials& trials);

/// Names of the models that defects are planted into.
std::vector<std::string> clean_subjects();

/// docs/mutators.md.
std::string markdown(const RepairTable& table);

/// Whether a document has the rows and columns of the table; "" or what it lacks.
std::string fault_of_form(std::string_view document);

}  // namespace rad::corpus
