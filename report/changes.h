// What a run of radfix changed, place by place, and where every face that it wrote came from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/finding.h"

namespace rad::report {

/// Where one thing happened.
struct ChangePlace {
  scene::FaceReference face;  ///< of the input
  geom::dvec3 at{0, 0, 0};    ///< file units
  double distance = 0;        ///< file units; 0 for what moves nothing
};

/// One sort of change. At most kListedPlaces are listed, the farthest first, else in the order of the faces.
struct Change {
  std::string kind;  ///< "moved", "cut", "divided", "merged", "turned", "won", "removed"
  std::uint64_t count = 0;
  std::vector<ChangePlace> places;
};

inline constexpr std::size_t kListedPlaces = 10;

/// A region where something moved farther than a vertex may outside of such regions.
struct MergedRegion {
  geom::dvec3 at{0, 0, 0};  ///< file units
  double distance = 0;      ///< file units
  std::uint64_t places = 0;
};

struct Changes {
  std::vector<Change> kinds;
  std::vector<MergedRegion> merged;
  double result_to_input = 0;  ///< a bound, file units
  double input_to_result = 0;  ///< measured, file units
};

/// Places of the faces of the input: a stretch of faces that refer to one section.
struct InputPlaces {
  std::size_t section = 0;
  std::string records;  ///< run text (run_text.h): of each face its record
};

struct Provenance {
  std::size_t output_faces = 0;
  std::string sources;  ///< run text: of each face of the output the faces of the input, counted from 0
  std::size_t input_faces = 0;
  std::vector<scene::SourceSection> sections;
  std::vector<InputPlaces> places;  ///< of all faces of the input, in order
};

/// One cell of the paper's Table 2 as it was found.
struct ContractCheck {
  std::string stage;        ///< the filter
  std::string requirement;  ///< "1a"…"3a"
  std::string cell;         ///< "required", "generated", "passed"
  std::uint64_t before = 0;  ///< sets of faces of the input that break it
  std::uint64_t after = 0;
  bool holds = true;
};

}  // namespace rad::report
