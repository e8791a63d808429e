#include "corpus/generate/shapes.h"

namespace rad::corpus {
namespace {

Ring facing_ring(const Frame& frame, const Outline& outline, int n, Facing facing) {
  return frame.ring(facing == Facing::Along ? outline : reversed(outline), n);
}

}  // namespace

void panel(Modeller& modeller, const Frame& frame, const Outline& outline, int n, Facing facing,
           const std::vector<Ring>& holes) {
  modeller.face(facing_ring(frame, outline, n, facing), holes);
}

void panel_with_contacts(Modeller& modeller, const Frame& frame, const Outline& outline, int n, Facing facing,
                         const std::vector<Ring>& contacts, const std::vector<Ring>& holes) {
  modeller.face_with_contacts(facing_ring(frame, outline, n, facing), contacts, holes);
}

Ring side(const Frame& frame, Planar a, Planar b, int low, int high) {
  return {frame.at(a, low), frame.at(b, low), frame.at(b, high), frame.at(a, high)};
}

void sides(Modeller& modeller, const Frame& frame, const Outline& outline, int low, int high) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    modeller.face(side(frame, outline[i], outline[(i + 1) % outline.size()], low, high));
  }
}

void prism(Modeller& modeller, const Frame& frame, const Outline& outline, int low, int high,
           const std::vector<Ring>& low_holes, const std::vector<Ring>& high_holes) {
  panel(modeller, frame, outline, low, Facing::Against, low_holes);
  panel(modeller, frame, outline, high, Facing::Along, high_holes);
  sides(modeller, frame, outline, low, high);
}

}  // namespace rad::corpus
