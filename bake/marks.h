// Marks drawn over a picture, after it was rendered: lines with a light casing, and signs whose shape says how severe.
#pragma once

#include <glm/vec2.hpp>

#include "bake/image.h"
#include "scene/finding.h"

namespace rad::bake {

/// Linear colour of a severity; told apart by eyes that do not tell red from green, and by lightness alone.
geom::dvec3 severity_colour(scene::Severity severity);

/// A line between two points of the picture, in pixels.
void draw_line(Image& image, const glm::dvec2& from, const glm::dvec2& to, const geom::dvec3& colour);

/// A sign of about 2 · `radius` pixels: a diamond for an error, a triangle for a warning, a disc for a note.
void draw_sign(Image& image, const glm::dvec2& at, scene::Severity severity, double radius);

}  // namespace rad::bake
