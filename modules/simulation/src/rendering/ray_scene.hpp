#pragma once

#include <memory>
#include <span>

#include "rendering/packet.hpp"
#include "rendering/surface.hpp"

namespace aisle {

/// Panels to shoot rays at, from anywhere to anywhere: for light and shadows. What a camera sees from its one
/// point is found faster by `find_seen`, which is held to the same hits.
class RayScene {
 public:
  RayScene(std::span<const Panel> panels, const SceneFrame& frame);

  /// The number of the first panel on each ray.
  void first_hits(const RayPacket& rays, Hits& hits) const;

  /// Sets `blocked` where a panel is between both ends of a segment that is asked for.
  void find_blocked(const SegmentPacket& segments, Flags& blocked) const;

  /// Distance to the first panel along sixteen segments [lengths of the segment]; 1: there is none.
  void free_shares(const SegmentPacket& segments, Floats& shares) const;

 private:
  struct Embree;
  std::shared_ptr<const Embree> embree_;
};

}  // namespace aisle
