// Findings written out in full, to the last bit, for comparing reports.
#pragma once

#include <ios>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "scene/finding.h"

namespace rad::tests {

inline void write_point(std::ostream& out, const geom::dvec3& p) {
  out << " (" << p.x << ' ' << p.y << ' ' << p.z << ')';
}

/// All of a finding but the faces and lines it names.
inline std::string text_without_faces(const scene::Finding& finding) {
  std::ostringstream out;
  out << std::hexfloat << finding.rule << ' ' << name(finding.severity) << ' ' << name(finding.kind) << " \""
      << finding.message << "\" count " << finding.count << " of " << finding.where.face_count << " faces";
  if (finding.measure) out << " measure " << finding.measure->value;
  if (finding.where.point) write_point(out << " at", *finding.where.point);
  for (const auto& span : {finding.where.segment, finding.where.bounds}) {
    if (!span) continue;
    write_point(out << " over", (*span)[0]);
    write_point(out, (*span)[1]);
  }
  for (const std::string& object : finding.where.objects) out << " object " << object;
  for (const std::string& material : finding.where.materials) out << " material " << material;
  out << " fingerprint " << finding.fingerprint;
  return out.str();
}

inline std::string text_in_full(const scene::Finding& finding) {
  std::string text =
      text_without_faces(finding) + " in " + finding.where.file + ":" + std::to_string(finding.where.line);
  for (const scene::FaceReference& face : finding.where.faces) text += " face " + face.ref;
  return text;
}

/// Violations per rule.
inline std::map<std::string, std::uint64_t> counts_by_rule(const std::vector<scene::Finding>& findings) {
  std::map<std::string, std::uint64_t> counts;
  for (const scene::Finding& finding : findings) counts[std::string(finding.rule)] += finding.count;
  return counts;
}

}  // namespace rad::tests
