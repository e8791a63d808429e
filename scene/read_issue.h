// What a reader could not take over from a file, and what it cannot believe. Rules RL001, RL002, RL006, RL010 and RL430
// to RL434 turn these into findings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace rad::scene {

enum class ReadIssueKind : std::uint8_t {
  ParseError,          ///< RL001: the file or a record of it is unreadable
  IndexOutOfRange,     ///< RL002: a face names a vertex that does not exist; the face is left out
  MissingResource,     ///< RL006: a companion file is absent or may not be opened
  UnsupportedContent,  ///< RL010: points, lines, curves, skins… that are not surfaces; left out
  PhotometrySyntax,    ///< RL430: a file of luminous intensities does not follow its format
  FluxMismatch,        ///< RL431: its intensities do not add up to the flux that it states
  PlaneGap,            ///< RL432: its planes or angles leave directions out
  PhotometrySymmetry,  ///< RL433: its planes are not those that its symmetry asks for
  TiltUnsupported,     ///< RL434: its intensities hang on how the lamp is tilted
};

/// Place of an issue: a 1-based line, a byte offset, a JSON pointer, or none of them.
struct IssuePlace {
  std::string file;  ///< empty: the file being read
  std::uint64_t line = 0;
  std::optional<std::uint64_t> byte_offset;
  std::string pointer;
};

struct ReadIssue {
  ReadIssueKind kind = ReadIssueKind::ParseError;
  std::string what;  ///< one clause, lower case, no full stop: "vertex index 9 exceeds the 8 vertices read so far"
  IssuePlace place;  ///< of the first occurrence
  std::uint64_t count = 1;
};

/// Collects issues; like ones beyond the first `kKept` of a kind only raise the count of the last.
class ReadIssues {
 public:
  static constexpr std::size_t kKept = 100;

  void add(ReadIssue issue);
  /// Counts an occurrence of content that is left out: one issue for each distinct `what`.
  void add_unsupported(std::string what, IssuePlace place);

  [[nodiscard]] const std::vector<ReadIssue>& all() const { return issues_; }
  [[nodiscard]] bool any(ReadIssueKind kind) const;

 private:
  std::vector<ReadIssue> issues_;
};

}  // namespace rad::scene
