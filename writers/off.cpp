#include "writers/off.h"

#include <vector>

#include "writers/bridged_ring.h"
#include "writers/head_comments.h"
#include "writers/text_line.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

void append_vertex(std::string& text, const geom::dvec3& vertex) {
  for (int axis = 0; axis < 3; ++axis) {
    append_number(text, vertex[axis]);
    text += axis < 2 ? ' ' : '\n';
  }
}

// Whether there was a corner to write.
bool append_face(std::string& text, const scene::Scene& scene, const scene::Face& face) {
  const std::vector<std::uint32_t> ring = bridged_ring(scene, face);
  if (ring.empty()) return false;
  append_number(text, ring.size());
  for (const std::uint32_t corner : ring) {
    text += ' ';
    append_number(text, scene.corners[corner]);
  }
  text += '\n';
  return true;
}

}  // namespace

WriteResult write_off(const Output& output, const std::filesystem::path& path) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem)};
  std::string body;
  for (const geom::dvec3& vertex : output.scene.vertices) append_vertex(body, vertex);
  std::size_t faces = 0;
  for (const scene::Face& face : output.scene.faces) faces += append_face(body, output.scene, face) ? 1 : 0;
  std::string text = "OFF\n";
  for (const std::string& comment : head_comments(output)) text += "# " + comment + "\n";
  append_number(text, output.scene.vertices.size());
  text += ' ';
  append_number(text, faces);
  text += " 0\n";
  return {write_whole_file(path, text + body)};
}

}  // namespace rad::writers
