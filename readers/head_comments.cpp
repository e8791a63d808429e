#include "readers/head_comments.h"

#include "readers/recorded_comment.h"
#include "readers/unit_comment.h"

namespace rad::readers {

void HeadComments::read(std::string_view comment) {
  if (const auto record = record_of_comment(comment)) recorded_ = record;
  if (const auto metres = metres_of_comment(comment)) {
    units_differ_ |= metres_ && *metres_ != *metres;
    metres_ = metres;
  }
  const scene::UpAxis up = up_axis_of_comment(comment);
  if (up == scene::UpAxis::Unknown) return;
  axes_differ_ |= up_ != scene::UpAxis::Unknown && up_ != up;
  up_ = up;
}

void HeadComments::apply(scene::Scene& scene) const {
  scene.recorded = recorded_;
  if (metres_ && !units_differ_) scene.metres_per_unit = metres_;
  if (!axes_differ_) scene.up = up_;
}

}  // namespace rad::readers
