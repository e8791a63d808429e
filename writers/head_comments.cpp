#include "writers/head_comments.h"

#include <fmt/format.h>

#include "writers/text_line.h"

namespace rad::writers {

std::string program_name() { return "radfix " RAD_VERSION; }

std::vector<std::string> head_comments(const Output& output) {
  std::vector<std::string> lines{"written by " + program_name()};
  if (output.lattice) {
    const geom::dvec3& origin = output.lattice->lattice.origin;
    lines.push_back(fmt::format("radfix T={} h={} origin={} {} {}", output.lattice->tolerance,
                                output.lattice->lattice.pitch, origin.x, origin.y, origin.z));
  }
  const scene::Scene& scene = output.scene;
  if (scene.metres_per_unit) lines.push_back(fmt::format("units: {} m", *scene.metres_per_unit));
  if (scene.up != scene::UpAxis::Unknown) lines.emplace_back(scene.up == scene::UpAxis::Y ? "up: y" : "up: z");
  if (output.marked_incomplete) lines.emplace_back("radfix incomplete");
  for (const std::string& comment : output.comments) lines.push_back(one_line(comment));
  return lines;
}

}  // namespace rad::writers
