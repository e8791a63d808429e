// A comparison of two judgements, written down.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "report/diff.h"
#include "report/formats.h"
#include "report/markdown_text.h"

namespace rad::report {

/// What is new, changed and fixed, by file and rule, and a verdict; for a terminal.
std::string diff_text(const Diff& diff, const TextOptions& options = {});

/// For a comment on a pull request, below `limit` bytes: the verdict and a table of rules always stay, lists of
/// findings are left out from the end, with a word that says so.
std::string diff_markdown(const Diff& diff, std::size_t limit = kMarkdownLimit);

/// Every finding of both sides, as diff.schema.json has it.
std::string diff_json(const Diff& diff);

/// Version of the JSON comparison's shape, semantic versioning.
inline constexpr std::string_view kDiffSchemaVersion = "1.0.0";

struct DiffFormat {
  std::string_view name;  ///< as after --format and before the = of --report
  std::string (*write)(const Diff& diff, const WriteOptions& options);
};

/// The first is that of standard output.
std::span<const DiffFormat> diff_formats();

/// Whether `diff` has regressions that reach fail_on of the new side.
bool fails(const Diff& diff);

/// "3 new, 2 fixed, 210 unchanged"; "no findings on either side" for none.
std::string diff_counts_text(const DiffCounts& counts);

/// "old.obj → new.obj"; one path where they are equal or a side is missing, which is said.
std::string diff_paths_text(const DiffFile& file);

/// T of both sides where they differ, else empty: findings near a threshold may come and go with it.
std::string diff_tolerance_text(const DiffFile& file);

}  // namespace rad::report
