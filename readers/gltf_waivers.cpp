#include "readers/gltf_waivers.h"

#include "readers/waiver_comment.h"

namespace rad::readers::gltf {
namespace {

const Json* member(const Json& json, const char* key) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find(key);
  return found == json.end() ? nullptr : &*found;
}

void add_rule(const Json& json, scene::Waiver& waiver) {
  if (json.is_string()) {
    waiver.rules.push_back(json.get<std::string>());
  } else {
    waiver.fault = "ignore holds something that is no text";
  }
}

class WaiverSearch {
 public:
  WaiverSearch(const Document& document, const ObjectsOfNodes& objects, const std::vector<scene::MaterialId>& materials)
      : json_(document.json), objects_(objects), materials_(materials) {}

  std::vector<scene::Waiver> run() {
    scene::Waiver whole;
    look_at(json_, "", whole);
    if (const Json* asset = member(json_, "asset")) look_at(*asset, "/asset", whole);
    look_at_nodes();
    look_at_meshes();
    look_at_materials();
    return std::move(waivers_);
  }

 private:
  void look_at_nodes() {
    for_each(json_, "nodes", "", [&](const Json& node, const std::string& pointer, std::size_t index) {
      const auto [first, last] = objects_.equal_range(index);
      for (auto object = first; object != last; ++object) {
        scene::Waiver frame;
        frame.scope = scene::WaiverScope::Object;
        frame.id = object->second;
        look_at(node, pointer, frame);
      }
    });
  }

  void look_at_meshes() {
    for_each(json_, "meshes", "", [&](const Json& mesh, const std::string& pointer, std::size_t) {
      look_at(mesh, pointer, at_or_below(pointer));
      for_each(mesh, "primitives", pointer, [&](const Json& primitive, const std::string& at, std::size_t) {
        look_at(primitive, at, at_or_below(at));
      });
    });
  }

  void look_at_materials() {
    for_each(json_, "materials", "", [&](const Json& material, const std::string& pointer, std::size_t index) {
      scene::Waiver frame;
      frame.scope = scene::WaiverScope::Material;
      frame.id = index < materials_.size() ? materials_[index] : 0;
      look_at(material, pointer, frame);
    });
  }

  template <typename Use>
  static void for_each(const Json& parent, const char* key, const std::string& pointer, Use use) {
    const Json* array = member(parent, key);
    if (array == nullptr || !array->is_array()) return;
    for (std::size_t i = 0; i < array->size(); ++i) {
      use((*array)[i], pointer + "/" + key + "/" + std::to_string(i), i);
    }
  }

  static scene::Waiver at_or_below(const std::string& pointer) {
    scene::Waiver frame;
    frame.scope = scene::WaiverScope::Primitive;
    frame.pointer = pointer;
    return frame;
  }

  void look_at(const Json& json, const std::string& pointer, const scene::Waiver& frame) {
    const Json* extras = member(json, "extras");
    const Json* asked = extras == nullptr ? nullptr : member(*extras, "radlint");
    if (asked == nullptr) return;
    const std::string place = pointer + "/extras/radlint";
    if (asked->is_string()) return add_text("radlint: " + asked->get<std::string>(), place, frame);
    const Json* ignore = member(*asked, "ignore");
    if (ignore == nullptr) return;  // whatever else is recorded there
    const Json* reason = member(*asked, "reason");
    add_ignore(*ignore, reason != nullptr && reason->is_string() ? reason->get<std::string>() : std::string(), place,
               frame);
  }

  void add_text(const std::string& text, const std::string& place, const scene::Waiver& frame) {
    auto read = waiver_of_comment(text);
    if (!read) return;
    scene::Waiver& waiver = waivers_.emplace_back(frame);
    waiver.rules = std::move(read->waiver.rules);
    waiver.reason = std::move(read->waiver.reason);
    waiver.fault = std::move(read->waiver.fault);
    waiver.place.pointer = place;
  }

  void add_ignore(const Json& ignore, const std::string& reason, const std::string& place, const scene::Waiver& frame) {
    if (ignore.is_object()) {
      for (const auto& [rule, why] : ignore.items()) {
        scene::Waiver& waiver = waivers_.emplace_back(frame);
        waiver.rules = {rule};
        waiver.reason = why.is_string() ? why.get<std::string>() : reason;
        waiver.place.pointer = place + "/ignore";
      }
      return;
    }
    scene::Waiver& waiver = waivers_.emplace_back(frame);
    waiver.reason = reason;
    waiver.place.pointer = place + "/ignore";
    if (!ignore.is_array()) return add_rule(ignore, waiver);
    for (const Json& rule : ignore) add_rule(rule, waiver);
    if (waiver.rules.empty() && waiver.fault.empty()) waiver.fault = "ignore names no rule";
  }

  const Json& json_;
  const ObjectsOfNodes& objects_;
  const std::vector<scene::MaterialId>& materials_;
  std::vector<scene::Waiver> waivers_;
};

}  // namespace

std::vector<scene::Waiver> read_waivers(const Document& document, const ObjectsOfNodes& objects,
                                        const std::vector<scene::MaterialId>& materials) {
  return WaiverSearch(document, objects, materials).run();
}

}  // namespace rad::readers::gltf
