// What checks look at: the scene, its lattice model and everything derived from them, computed once.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "scene/read_issue.h"
#include "validate/facades.h"
#include "validate/parameter.h"
#include "validate/topology.h"

namespace rad::validate {

using geom::dvec3;

struct Context {
  const scene::Scene& scene;
  const scene::ReadIssues& issues;
  scene::LatticeModel model;
  geom::Tolerance tolerance;
  FaceTriangles triangles;
  Contacts contacts;
  Topology topology;
  std::vector<geom::Box> object_boxes;       ///< per object, file units; empty where it has no sound corner
  std::vector<std::uint32_t> contact_start;  ///< per face, into contact_index; one more than there are faces
  std::vector<std::uint32_t> contact_index;
  mutable std::optional<Facades> facades{};  ///< facades_of() fills it when the first rule asks

  mutable std::optional<std::vector<std::uint32_t>> enclosing{};  ///< enclosing_components() fills it
  ParameterValues parameters{};  ///< of the rules, where they differ from the standard ones

  /// A threshold of a rule that configuration may set.
  [[nodiscard]] double parameter(const Rule& rule, std::string_view name) const { return parameters.of(rule, name); }

  /// Fills contact_start and contact_index from contacts.
  void index_contacts();

  /// File coordinates of a point given in lattice units.
  [[nodiscard]] dvec3 position(const dvec3& lattice_units) const {
    return model.lattice.origin + model.lattice.pitch * lattice_units;
  }
  [[nodiscard]] dvec3 position(PointId point) const { return model.position(point); }
  /// A length in pitches as file units.
  [[nodiscard]] double length(double pitches) const { return pitches * model.lattice.pitch; }
  [[nodiscard]] double area(double square_pitches) const {
    return square_pitches * model.lattice.pitch * model.lattice.pitch;
  }
  /// Mean of the corners of a face, file units; for saying where a face is.
  [[nodiscard]] dvec3 centre(FaceId face) const;
  [[nodiscard]] bool is_sound(FaceId face) const { return triangles.condition[face] == FaceCondition::Sound; }
  [[nodiscard]] scene::MaterialId material_of(FaceId face) const { return scene.faces[face].material; }
  [[nodiscard]] scene::ObjectId object_of(FaceId face) const { return scene.faces[face].object; }
  /// Indices into contacts.faces of all contacts of a face.
  [[nodiscard]] std::pair<const std::uint32_t*, const std::uint32_t*> contacts_of(FaceId face) const;
  /// An order of faces that does not depend on their ids: by names of object and material, then by place. Faces that
  /// coincide in all of these are ordered by id.
  [[nodiscard]] bool precedes(FaceId a, FaceId b) const;
};

/// The tolerance that a scene is judged at. Nothing where the one asked for cannot be used; then `refusal` says why.
std::optional<geom::Tolerance> chosen_tolerance(const scene::Scene& scene, const scene::LatticeModel& model,
                                                const std::optional<geom::ToleranceRequest>& tolerance,
                                                std::string& refusal);

/// Derives everything from a scene. Nothing where the tolerance asked for cannot be used; then `refusal` says why.
/// `lap`, where given, is called with the name of each step that was done.
std::optional<Context> build_context(const scene::Scene& scene, const scene::ReadIssues& issues,
                                     const std::optional<geom::ToleranceRequest>& tolerance, std::string& refusal,
                                     const std::function<void(std::string_view)>& lap = {});

/// The context of a scene that differs from that of `before` in nothing but that the faces in `turned`, ascending, look
/// the other way. Takes over what does not depend on that.
Context context_after_turning(Context before, const scene::Scene& scene, const std::vector<FaceId>& turned);

}  // namespace rad::validate
