// What meshing makes is judged by the same rules as any other model: nothing that was sound may become a fault.
#include <gtest/gtest.h>

#include "mesh/element_views.h"
#include "mesh/emesh.h"
#include "scene/scene_builder.h"
#include "tests/mesh/sound_patches.h"
#include "validate/lint.h"

namespace rad::tests {
namespace {

// One vertex for each vertex of the display mesh, as a format that repeats vertices at seams holds it.
scene::Scene scene_of(const mesh::DisplayMesh& display, const scene::ConformingModel& model) {
  scene::SceneBuilder builder("scene.ply", "ply");
  builder.add_section({"scene.ply", "", scene::RecordKind::Element});
  builder.scene().splits_vertices = true;
  builder.scene().recorded = scene::RecordedLattice{model.lattice, model.tolerance.length};
  for (const auto& vertex : display.vertices) builder.add_vertex(model.lattice.position(vertex.point));
  for (const auto& face : display.faces) {
    builder.use_material(builder.material("m" + std::to_string(face.material)));
    builder.add_face(std::span(face.corner).first(face.count), builder.scene().faces.size());
  }
  return builder.take();
}

// Errors at the stages that meshing is to reach; the rules on facades and normals judge the model, not its mesh.
std::vector<std::string> faults(const ConformingBuilder& builder, double patch, double element) {
  mesh::ElementMesh elements(meshed(builder, patch));
  mesh::emesh(elements, {.longest_edge = element});
  LatticeRandom random(3);
  std::vector<mesh::ElementId> some;
  for (const auto leaf : elements.leaves()) {
    if (random.one_in(7)) some.push_back(leaf);
  }
  elements.refine(some);
  const scene::Scene scene = scene_of(mesh::display_mesh(elements), builder.model());
  std::vector<std::string> found;
  for (const validate::Stage stage : {validate::Stage::Model, validate::Stage::Solve, validate::Stage::Display}) {
    validate::LintOptions options;
    options.stage = stage;
    options.tolerance = geom::ToleranceRequest{builder.model().tolerance.length};
    const validate::LintResult result = validate::lint(scene, {}, options);
    EXPECT_EQ(result.refusal, "");
    EXPECT_DOUBLE_EQ(result.tolerance->length, builder.model().tolerance.length);
    for (const auto& finding : result.findings) {
      const bool dark = finding.rule == "RL402";  // nothing here is meant to emit
      if (finding.severity == scene::Severity::Error && !dark)
        found.push_back(std::string(finding.rule) + " " + finding.message);
    }
  }
  return found;
}

void expect_clean(const ConformingBuilder& builder, double patch, double element) {
  const auto found = faults(builder, patch, element);
  for (const std::string& fault : found) ADD_FAILURE() << fault;
}

TEST(Relint, FindsNoFaultInABox) {
  ConformingBuilder builder;
  builder.add_box(at(0, 0, 0), at(5, 4, 3));
  expect_clean(builder, 0.7, 0.3);
}

TEST(Relint, FindsNoFaultInTiltedFaces) {
  ConformingBuilder builder;
  builder.add_face(tilted(circle(0, 0, 6, 40)), {reversed(tilted(circle(1, 1, 2, 17)))});
  expect_clean(builder, 0.9, 0.4);
}

TEST(Relint, FindsNoFaultAroundHoles) {
  ConformingBuilder builder;
  std::vector<Ring3> holes;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) holes.push_back(reversed(circle(1 + i, 1 + j, 0.2 + 0.06 * ((i + j) % 4), 7 + 2 * i)));
  }
  builder.add_face(rectangle(0, 0, 5, 5), holes);
  expect_clean(builder, 0.6, 0.2);
  expect_clean(builder, 4, 4);
}

TEST(Relint, FindsNoFaultInACircleOfManyEdges) {
  ConformingBuilder builder;
  builder.add_face(circle(0, 0, 60, 2000));
  expect_clean(builder, 20, 20);
}

// Polygons that keep T themselves, as the repair leaves them; some have patches that nearly fill them.
TEST(Relint, FindsNoFaultInRandomPolygons) {
  LatticeRandom random(11);
  for (int trial = 0; trial < 60; ++trial) {
    const auto corners = random.between(4, 30);
    Ring3 ring;
    for (std::int64_t i = 0; i < corners; ++i) {
      const double angle =
          2 * std::numbers::pi * (static_cast<double>(i) + 0.5 * random.unit()) / static_cast<double>(corners);
      const double radius = 4 + 4 * random.unit();
      ring.push_back(at(radius * std::cos(angle), radius * std::sin(angle)));
    }
    ConformingBuilder builder;
    builder.add_face(trial % 2 == 0 ? ring : tilted(ring));
    SCOPED_TRACE(trial);
    const double patch = 0.5 + 4 * random.unit();
    expect_clean(builder, patch, patch / 3);
  }
}

TEST(Relint, FindsNoFaultWhereAWallStands) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 4, 4), {}, {{{at(1, 2), at(3, 2)}}});
  builder.add_face({at(1, 2), at(3, 2), at(3, 2, 1), at(1, 2, 1)});
  expect_clean(builder, 0.6, 0.3);
}

TEST(Relint, FindsNoFaultInNeedles) {
  ConformingBuilder builder;
  builder.add_face({at(0, 0), at(20, 0), at(20, 1)});
  builder.add_face({at(0, 0, 3), at(10, 0.08, 3), at(20, 0, 3)});
  Ring3 star;
  for (int i = 0; i < 24; ++i) {
    const double angle = std::numbers::pi * i / 12, radius = i % 2 == 0 ? 12 : 0.8;
    star.push_back(at(radius * std::cos(angle), radius * std::sin(angle), 5));
  }
  builder.add_face(star);
  expect_clean(builder, 0.7, 0.3);
}

// A narrow strip stands on the long edge of a floor at an angle: points of either near the edge lie near the other.
TEST(Relint, FindsNoFaultWhereFacesMeetAtASharpAngle) {
  for (const double degrees : {21.0, 37.0, 60.0}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * std::numbers::pi / 180, width = 0.3;
    const double x = width * std::cos(angle), z = width * std::sin(angle);
    ConformingBuilder builder;
    builder.add_face({at(0, 0), at(4, 0), at(4, 20), at(0, 20)});
    builder.add_face({at(0, 0), at(0, 20), at(x, 19, z), at(x, 1, z)});
    expect_clean(builder, 0.7, 0.2);
    expect_clean(builder, 3, 0.2);
  }
}

// Two faces have one corner in common, and from there an edge of either runs along the other's, a few T away at its
// end.
TEST(Relint, FindsNoFaultWhereEdgesLeaveACornerAtAHair) {
  for (const double apart : {1.4, 2.0, 3.0, 7.0}) {
    SCOPED_TRACE(apart);
    ConformingBuilder builder;
    const double away = apart * static_cast<double>(kBuilderTolerance) / kUnit;
    builder.add_face({at(0, 0), at(20, 0), at(12, 9)});
    builder.add_face({at(0, 0), at(11, -7, -away / 2), at(17, 0, -away)});
    expect_clean(builder, 3, 0.2);
    expect_clean(builder, 30, 1);
  }
}

}  // namespace
}  // namespace rad::tests
