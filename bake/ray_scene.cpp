#include "bake/ray_scene.h"

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <new>

namespace rad::bake {
namespace {

using geom::dvec3;

/// The scene moved and scaled into the cube from -1 to 1, where single precision serves every scene alike.
struct UnitCube {
  dvec3 centre{0, 0, 0};
  double half_size = 1;

  [[nodiscard]] dvec3 inside(const dvec3& point) const { return (point - centre) / half_size; }
};

UnitCube cube_around(const scene::Scene& scene, std::span<const DrawnTriangle> triangles) {
  geom::Box box;
  for (const DrawnTriangle& triangle : triangles) {
    for (const scene::VertexId id : triangle.corners) box.add(scene.vertices[id]);
  }
  UnitCube cube;
  if (box.empty()) return cube;
  const dvec3 half = box.high * 0.5 - box.low * 0.5;
  cube.centre = box.low * 0.5 + box.high * 0.5;
  const double size = std::max({half.x, half.y, half.z});
  if (size > 0) cube.half_size = size;
  return cube;
}

bool from_behind(float normal_x, float normal_y, float normal_z, const RTCRay& ray) {
  return normal_x * ray.dir_x + normal_y * ray.dir_y + normal_z * ray.dir_z > 0;
}

void refuse_back_faces(const RTCFilterFunctionNArguments* arguments) {
  const auto& ray = *reinterpret_cast<const RTCRay*>(arguments->ray);
  const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
  if (from_behind(hit.Ng_x, hit.Ng_y, hit.Ng_z, ray)) arguments->valid[0] = 0;
}

}  // namespace

struct RayScene::Rays {
  UnitCube cube;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  // Embree runs out of memory or not at all; both end the program as any other lack of memory does.
  Rays() : device(rtcNewDevice(nullptr)) {
    if (device == nullptr) throw std::bad_alloc();
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
  }
  Rays(const Rays&) = delete;
  Rays& operator=(const Rays&) = delete;
  ~Rays() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  void add(const scene::Scene& model, std::span<const DrawnTriangle> triangles, BackFaces back_faces) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
    auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    if (positions == nullptr || corners == nullptr) throw std::bad_alloc();
    std::uint32_t next = 0;
    for (const DrawnTriangle& triangle : triangles) {
      for (const scene::VertexId id : triangle.corners) {
        const dvec3 p = cube.inside(model.vertices[id]);
        for (int axis = 0; axis < 3; ++axis) positions[3 * next + axis] = static_cast<float>(p[axis]);
        corners[next] = next;
        ++next;
      }
    }
    if (back_faces == BackFaces::SeenThrough) rtcSetGeometryIntersectFilterFunction(geometry, refuse_back_faces);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  // One thread builds the tree: of two triangles at the same distance the first in the tree is met, so the tree must
  // not hang on how the work was shared out.
  void commit() {
    tbb::task_arena alone(1);
    alone.execute([this] { rtcJoinCommitScene(scene); });
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::bad_alloc();
  }
};

RayScene::RayScene(const scene::Scene& scene, std::span<const DrawnTriangle> triangles, BackFaces back_faces)
    : rays_(std::make_unique<Rays>()) {
  rays_->cube = cube_around(scene, triangles);
  if (!triangles.empty()) rays_->add(scene, triangles, back_faces);
  rays_->commit();
}

RayScene::~RayScene() = default;

std::optional<RayHit> RayScene::nearest(const dvec3& origin, const dvec3& direction) const {
  const dvec3 from = rays_->cube.inside(origin);
  const dvec3 along = glm::normalize(direction);
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(from.x);
  query.ray.org_y = static_cast<float>(from.y);
  query.ray.org_z = static_cast<float>(from.z);
  query.ray.dir_x = static_cast<float>(along.x);
  query.ray.dir_y = static_cast<float>(along.y);
  query.ray.dir_z = static_cast<float>(along.z);
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = 0xffffffffu;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect1(rays_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{.triangle = query.hit.primID,
                .u = query.hit.u,
                .v = query.hit.v,
                .distance = query.ray.tfar * rays_->cube.half_size,
                .from_behind = from_behind(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z, query.ray)};
}

}  // namespace rad::bake
