#include "solve/visibility.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>
#ifdef __SSE2__
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace rad::solve {
namespace {

constexpr std::size_t kPacket = 16;

/// Embree asks for subnormal numbers to be flushed; everything else here relies on them, so only around its calls.
class FlushedSubnormals {
 public:
#ifdef __SSE2__
  FlushedSubnormals() : saved_(_mm_getcsr()) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FlushedSubnormals() { _mm_setcsr(saved_); }

 private:
  unsigned saved_;
#endif
};

struct Packet {
  alignas(64) int valid[kPacket];
  RTCRay16 rays;
};

void set_ray(Packet& packet, std::size_t lane, const Segment& segment, const dvec3& origin) {
  const dvec3 from = segment.from - origin;
  const dvec3 along = segment.to - segment.from;
  packet.valid[lane] = -1;
  packet.rays.org_x[lane] = static_cast<float>(from.x);
  packet.rays.org_y[lane] = static_cast<float>(from.y);
  packet.rays.org_z[lane] = static_cast<float>(from.z);
  packet.rays.dir_x[lane] = static_cast<float>(along.x);
  packet.rays.dir_y[lane] = static_cast<float>(along.y);
  packet.rays.dir_z[lane] = static_cast<float>(along.z);
  packet.rays.tnear[lane] = 0;
  packet.rays.tfar[lane] = 1;
  packet.rays.time[lane] = 0;
  packet.rays.mask[lane] = std::numeric_limits<unsigned>::max();
  packet.rays.id[lane] = static_cast<unsigned>(lane);
  packet.rays.flags[lane] = 0;
}

}  // namespace

struct Visibility::Tracer {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  dvec3 origin{0, 0, 0};  ///< single precision is finest near it

  ~Tracer() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void check() const {
    const RTCError error = rtcGetDeviceError(device);
    if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree error " + std::to_string(error));
  }

  void place_origin(const mesh::RadiosityMesh& mesh) {
    dvec3 sum{0, 0, 0};
    for (const mesh::Node& node : mesh.nodes) sum += node.position;
    if (!mesh.nodes.empty()) origin = sum / static_cast<double>(mesh.nodes.size());
  }

  void add_triangles(const mesh::RadiosityMesh& mesh) {
    std::vector<std::array<unsigned, 3>> triangles;
    for (const mesh::Patch& patch : mesh.patches) {
      const auto& node = patch.corners.node;
      for (std::uint32_t i = 2; i < patch.corners.count; ++i) triangles.push_back({node[0], node[i - 1], node[i]});
    }
    if (triangles.empty()) return;
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.nodes.size()));
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), triangles.size()));
    check();
    for (const mesh::Node& node : mesh.nodes) {
      for (int axis = 0; axis < 3; ++axis) *points++ = static_cast<float>(node.position[axis] - origin[axis]);
    }
    for (const auto& triangle : triangles) corners = std::copy(triangle.begin(), triangle.end(), corners);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
};

Visibility::Visibility(const mesh::RadiosityMesh& mesh) : tracer_(std::make_unique<Tracer>()) {
  const FlushedSubnormals flushed;
  tracer_->device = rtcNewDevice(nullptr);
  if (!tracer_->device) throw std::runtime_error("Embree cannot be set up");
  tracer_->scene = rtcNewScene(tracer_->device);
  rtcSetSceneFlags(tracer_->scene, RTC_SCENE_FLAG_ROBUST);
  // High quality splits triangles: a ray through a split edge could pass.
  rtcSetSceneBuildQuality(tracer_->scene, RTC_BUILD_QUALITY_MEDIUM);
  tracer_->place_origin(mesh);
  tracer_->add_triangles(mesh);
  rtcCommitScene(tracer_->scene);
  tracer_->check();
}

Visibility::~Visibility() = default;

void Visibility::trace(std::span<const Segment> segments, std::span<std::uint8_t> blocked) const {
  const FlushedSubnormals flushed;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  Packet packet;
  for (std::size_t first = 0; first < segments.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, segments.size() - first);
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
      set_ray(packet, lane, segments[first + std::min(lane, count - 1)], tracer_->origin);
      if (lane >= count) packet.valid[lane] = 0;
    }
    rtcOccluded16(packet.valid, tracer_->scene, &context, &packet.rays);
    for (std::size_t lane = 0; lane < count; ++lane) blocked[first + lane] = packet.rays.tfar[lane] < 0;
  }
}

}  // namespace rad::solve
