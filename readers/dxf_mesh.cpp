// The MESH entity: the cage of a subdivision surface, as vertices and a list of faces.
#include "readers/dxf_polyline.h"
#include "readers/refusals.h"

namespace rad::readers::dxf {
namespace {

using scene::VertexId;

class MeshEntity {
 public:
  MeshEntity(const Entity& entity, Surfaces& surfaces) : entity_(entity), surfaces_(surfaces) {}

  void run() {
    if (entity_.integer(91) > 0) surfaces_.count_unsupported("smoothing of MESH entities", entity_.line());
    for (const Group& group : entity_.groups()) {
      switch (group.code) {
        case 92:  // number of vertices; 93, 94 and 95 begin the lists of faces, edges and creases
        case 93:
        case 94:
        case 95:
          list_ = group.code;
          break;
        case 10:
        case 20:
        case 30:
          if (list_ == 92) take_coordinate(group);
          break;
        case 90:
          if (list_ == 93) take_face_number(group);
          break;
        default:
          break;
      }
      if (surfaces_.full()) return;
    }
    if (left_ > 0) refuse("the list of faces of a MESH ends within a face", entity_.line());
  }

 private:
  void refuse(std::string what, std::uint64_t line) {
    surfaces_.refuse(scene::ReadIssueKind::ParseError, std::move(what), line);
  }

  void take_coordinate(const Group& group) {
    point_[(group.code - 10) / 10] = entity_.number_of(group);
    if (group.code == 30) vertices_.push_back(surfaces_.add_vertex(point_, group.line));
  }

  // A count, then as many vertices from 0.
  void take_face_number(const Group& group) {
    const std::int64_t number = entity_.integer_of(group);
    if (left_ == 0) {
      left_ = number > 0 ? number : 0;
      sound_ = true;
      line_ = group.line;
      corners_.clear();
      return;
    }
    --left_;
    if (number >= 0 && static_cast<std::uint64_t>(number) < vertices_.size()) {
      corners_.push_back(vertices_[static_cast<std::size_t>(number)]);
    } else if (sound_) {
      sound_ = false;
      surfaces_.refuse(scene::ReadIssueKind::IndexOutOfRange, index_outside(number, vertices_.size()), group.line);
    }
    if (left_ == 0 && sound_) surfaces_.add_face(corners_, line_);
  }

  const Entity& entity_;
  Surfaces& surfaces_;
  int list_ = 0;
  dvec3 point_{0, 0, 0};
  std::vector<VertexId> vertices_;
  std::vector<VertexId> corners_;
  std::int64_t left_ = 0;
  bool sound_ = true;
  std::uint64_t line_ = 0;
};

}  // namespace

void add_mesh(const Entity& entity, Surfaces& surfaces) { MeshEntity(entity, surfaces).run(); }

}  // namespace rad::readers::dxf
