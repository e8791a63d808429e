// A finding: one cluster of like violations of the same participants, ready to be reported.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace rad::scene {

enum class Severity : std::uint8_t { Note, Warning, Error };

/// Fail: shown to be wrong. Review: a person has to decide. Informational: counted, not wrong.
enum class FindingKind : std::uint8_t { Fail, Review, Informational };

/// What repair may do about a finding: on its own, on request only, or not at all.
enum class FixClass : std::uint8_t { Safe, Unsafe, Manual, None };

/// A number and the threshold it is held against, both in `unit` ("m", "file units", "file units²", "1").
struct Measure {
  std::string_view name;
  double value = 0;
  std::optional<double> threshold;
  std::string_view unit;
};

/// A face that takes part, as a user finds it: "chair.obj:120", "plan.dxf:88 (handle 2F)", line 120 (0 where the format
/// has none), pointer.
struct FaceReference {
  std::string ref;
  std::uint64_t line = 0;
  std::string pointer;
  std::string entity;  ///< name of the record in its file, as "handle 2F"; empty where it has none
};

/// `face` must be one of the scene.
FaceReference reference_to(const Scene& scene, FaceId face);

/// One violation as it is drawn over the model: a point, a segment, or both. File units.
struct FaultPlace {
  std::optional<dvec3> point;
  std::optional<std::array<dvec3, 2>> segment;
};

struct Where {
  std::optional<dvec3> point;                   ///< file units, of the worst violation
  std::optional<std::array<dvec3, 2>> segment;  ///< file units, of the worst violation
  std::optional<std::array<dvec3, 2>> bounds;   ///< file units, low and high corner of all violations
  std::optional<dvec3> frame;  ///< file units, low corner of the object that the fingerprint tells the place in
  std::string file;
  std::uint64_t line = 0;  ///< 1-based, 0 where there is none
  std::optional<std::uint64_t> byte_offset;
  std::string pointer;                 ///< JSON pointer
  std::vector<std::string> objects;    ///< names, sorted
  std::vector<std::string> materials;  ///< names, sorted
  std::vector<FaceReference> faces;    ///< those of the worst violation first, at most kListedFaces
  std::uint64_t face_count = 0;        ///< of all faces that take part
  std::vector<FaceId> face_ids;        ///< of all of them, ascending, in the scene that was judged; for drawings
  std::vector<FaultPlace> places;      ///< of the violations, worst first, at most kDrawnPlaces; for drawings
};

inline constexpr std::size_t kListedFaces = 10;
inline constexpr std::size_t kDrawnPlaces = 256;

struct Fix {
  FixClass applicability = FixClass::None;
  std::string_view operation;  ///< id of the radfix operation, empty for none
};

/// How a finding stands to a baseline of known ones.
enum class BaselineState : std::uint8_t {
  None,   ///< there is no baseline
  New,    ///< it does not know it
  Grown,  ///< it knows it with fewer violations or a lower severity
  Known,
};

struct Finding {
  std::string_view rule;         ///< "RL201"
  std::string_view alias;        ///< "t-vertex"
  std::string_view requirement;  ///< "1a"…"3a", "input", "materials", "units"
  Severity severity = Severity::Error;
  FindingKind kind = FindingKind::Fail;
  std::string message;
  std::optional<Measure> measure;
  std::optional<double> area;        ///< file units², over all violations, of a fault with extent
  std::optional<double> kept_below;  ///< largest T, file units, that keeps what T would lose; 0 where none does
  Where where;
  std::uint64_t count = 1;  ///< violations in the cluster
  std::string fingerprint;  ///< the same for the same fault after renumbering, shuffling or re-export
  Fix fix;
  BaselineState baseline = BaselineState::None;
};

std::string_view name(Severity severity);
std::string_view name(FindingKind kind);
std::string_view name(FixClass applicability);
std::string_view name(BaselineState state);  ///< "", "new", "grown", "known"

}  // namespace rad::scene
