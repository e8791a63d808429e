#include "validate/overlaps.h"

#include "scene/twins.h"
#include "validate/neighbours.h"

namespace rad::validate {
namespace {

OverlapKind kind_of(const Context& context, const FaceContact& contact) {
  const bool same_material = context.material_of(contact.a) == context.material_of(contact.b);
  if (contact.same_facing) return same_material ? OverlapKind::SameMaterial : OverlapKind::DifferentMaterial;
  const bool same_object = context.object_of(contact.a) == context.object_of(contact.b);
  const bool twin = same_material && same_object && have_the_same_corners(context, contact.a, contact.b);
  return twin ? OverlapKind::Twin : OverlapKind::Hidden;
}

// A face and the twin that radfix gave it on request.
bool is_asked_for(const Context& context, const FaceContact& contact) {
  const std::string &a = context.scene.objects[context.object_of(contact.a)],
                    &b = context.scene.objects[context.object_of(contact.b)];
  return a == scene::twin_name(b) || b == scene::twin_name(a);
}

}  // namespace

void report_overlaps(const Context& context, OverlapKind kind, Violations& out) {
  for (const FaceContact& contact : context.contacts.faces) {
    if (contact.kind != geom::ContactKind::Overlap || kind_of(context, contact) != kind) continue;
    if (!contact.same_facing && is_asked_for(context, contact)) continue;
    const bool ordered = context.precedes(contact.a, contact.b);
    out.add({.faces = {ordered ? contact.a : contact.b, ordered ? contact.b : contact.a},
             .point = context.position(contact.segment[0]),
             .measure = context.area(contact.size)});
  }
}

}  // namespace rad::validate
