#include "mesh/patch_rays.h"

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <limits>
#include <new>
#include <vector>

namespace rad::mesh {

namespace {

void aim(RTCRay& ray, const dvec3& from, const dvec3& direction) {
  ray.org_x = static_cast<float>(from.x);
  ray.org_y = static_cast<float>(from.y);
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.mask = std::numeric_limits<unsigned>::max();
}

}  // namespace

struct PatchRays::Tracer {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<PatchId> patch_of_triangle;

  Tracer() : device(rtcNewDevice(nullptr)) {
    if (device == nullptr) throw std::bad_alloc();
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
  }
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;
  ~Tracer() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  // Lattice coordinates are exact in single precision.
  void add(const ElementMesh& mesh) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (PatchId patch = 0; patch < mesh.patch_count(); ++patch) {
      const Corners corners = mesh.corners(patch);
      for (std::uint32_t i = 1; i + 1 < corners.count; ++i) {
        triangles.push_back(
            {mesh.point_of(corners.node[0]), mesh.point_of(corners.node[i]), mesh.point_of(corners.node[i + 1])});
        patch_of_triangle.push_back(patch);
      }
    }
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.points().size()));
    auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    if (places == nullptr || corners == nullptr) throw std::bad_alloc();
    for (const geom::LatticePoint& p : mesh.points()) {
      for (const std::int32_t value : {p.x, p.y, p.z}) *places++ = static_cast<float>(value);
    }
    for (const auto& triangle : triangles) corners = std::copy(triangle.begin(), triangle.end(), corners);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  // By one thread: which of two triangles at one distance is met must not hang on how the work was shared out.
  void commit() {
    tbb::task_arena alone(1);
    alone.execute([this] { rtcJoinCommitScene(scene); });
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::bad_alloc();
  }
};

PatchRays::PatchRays(const ElementMesh& mesh) : tracer_(std::make_unique<Tracer>()) {
  if (mesh.patch_count() > 0) tracer_->add(mesh);
  tracer_->commit();
}

PatchRays::~PatchRays() = default;

std::optional<PatchHit> PatchRays::nearest(const dvec3& from, const dvec3& direction) const {
  RTCRayHit query{};
  aim(query.ray, from, direction);
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(tracer_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return PatchHit{tracer_->patch_of_triangle[query.hit.primID], static_cast<double>(query.ray.tfar)};
}

bool PatchRays::blocked(const dvec3& from, const dvec3& direction, double length) const {
  RTCRay ray{};
  aim(ray, from, direction);
  ray.tfar = static_cast<float>(length);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(tracer_->scene, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace rad::mesh
