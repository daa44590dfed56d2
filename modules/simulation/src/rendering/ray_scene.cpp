#include "rendering/ray_scene.hpp"

#include <embree3/rtcore.h>
#include <tbb/global_control.h>

#include <limits>
#include <stdexcept>

namespace aisle {
namespace {

constexpr float kNear = 1e-4f;  ///< nearer hits are ignored [lengths of the direction]
constexpr Flags kAll{{-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1}};

/// One instruction set for all machines that have it. Its own limit of threads would hold for the whole
/// program as long as it lives, so it has none.
RTCDevice new_device() {
  const char* settings =
      __builtin_cpu_supports("avx2") ? "set_affinity=0,isa=avx2" : "set_affinity=0,isa=sse4.2";
  const RTCDevice device = rtcNewDevice(settings);
  if (device == nullptr) throw std::runtime_error("the ray tracer cannot be started");
  return device;
}

RTCGeometry quads(RTCDevice device, std::span<const Panel> panels, const SceneFrame& frame) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4 * panels.size()));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), panels.size()));
  unsigned vertex = 0;
  for (const Panel& panel : panels) {
    for (const Vec3& corner : panel.corners()) {
      const Eigen::Vector3f p = frame(corner).cast<float>();
      *vertices++ = p.x();
      *vertices++ = p.y();
      *vertices++ = p.z();
      *indices++ = vertex++;
    }
  }
  rtcCommitGeometry(geometry);
  return geometry;
}

void start(RTCRay16& ray, int k, float x, float y, float z, float to_x, float to_y, float to_z, float far) {
  ray.org_x[k] = x;
  ray.org_y[k] = y;
  ray.org_z[k] = z;
  ray.dir_x[k] = to_x;
  ray.dir_y[k] = to_y;
  ray.dir_z[k] = to_z;
  ray.tnear[k] = kNear;
  ray.tfar[k] = far;
  ray.time[k] = 0;
  ray.mask[k] = std::numeric_limits<unsigned>::max();
  ray.id[k] = 0;
  ray.flags[k] = 0;
}

/// A lane that is not asked for may hold NaN, and the ray tracer reads it nevertheless.
void start(RTCRay16& ray, int k, const SegmentPacket& segments, float far) {
  constexpr float kNowhere = -1;
  if (segments.asked.at[k] == 0) return start(ray, k, 0, 0, 0, 1, 0, 0, kNowhere);
  start(ray, k, segments.from_x.at[k], segments.from_y.at[k], segments.from_z.at[k], segments.x.at[k],
        segments.y.at[k], segments.z.at[k], far);
}

RTCIntersectContext context(RTCIntersectContextFlags flags) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  return context;
}

}  // namespace

struct RayScene::Embree {
  RTCDevice device = new_device();
  RTCScene scene = rtcNewScene(device);

  Embree() = default;
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
};

RayScene::RayScene(std::span<const Panel> panels, const SceneFrame& frame) {
  if (panels.empty()) return;
  auto embree = std::make_shared<Embree>();
  const RTCGeometry geometry = quads(embree->device, panels, frame);
  rtcAttachGeometry(embree->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(embree->scene, RTC_SCENE_FLAG_ROBUST);
  {
    // By one thread, so that it is always built the same.
    const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
    rtcCommitScene(embree->scene);
  }
  embree_ = std::move(embree);
}

void RayScene::first_hits(const RayPacket& rays, Hits& hits) const {
  for (std::uint32_t& hit : hits.at) hit = kNoSurface;
  if (!embree_) return;
  alignas(64) RTCRayHit16 packet;
  for (int k = 0; k < kLanes; ++k) {
    start(packet.ray, k, rays.origin[0], rays.origin[1], rays.origin[2], rays.x.at[k], rays.y.at[k],
          rays.z.at[k], std::numeric_limits<float>::infinity());
    packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext coherent = context(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  rtcIntersect16(kAll.at, embree_->scene, &coherent, &packet);
  for (int k = 0; k < kLanes; ++k) {
    const bool is_hit = packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    hits.at[k] = is_hit ? packet.hit.primID[k] : kNoSurface;
  }
}

void RayScene::find_blocked(const SegmentPacket& segments, Flags& blocked) const {
  if (!embree_) return;
  constexpr float kBeforeTheEnd = 0.999f;
  alignas(64) RTCRay16 packet;
  for (int k = 0; k < kLanes; ++k) start(packet, k, segments, kBeforeTheEnd);
  RTCIntersectContext coherent = context(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  rtcOccluded16(segments.asked.at, embree_->scene, &coherent, &packet);
  for (int k = 0; k < kLanes; ++k) {
    if (segments.asked.at[k] != 0 && packet.tfar[k] < 0) blocked.at[k] = -1;
  }
}

void RayScene::free_shares(const SegmentPacket& segments, Floats& shares) const {
  for (float& share : shares.at) share = 1;
  if (!embree_) return;
  alignas(64) RTCRayHit16 packet;
  for (int k = 0; k < kLanes; ++k) {
    start(packet.ray, k, segments, 1);
    packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext scattered = context(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  rtcIntersect16(segments.asked.at, embree_->scene, &scattered, &packet);
  for (int k = 0; k < kLanes; ++k) {
    if (segments.asked.at[k] != 0) shares.at[k] = packet.ray.tfar[k];
  }
}

}  // namespace aisle
