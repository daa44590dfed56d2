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

  /// Sets `blocked` where a panel stands between both ends of a path that is asked for.
  void find_blocked(const PathPacket& paths, Flags& blocked) const;

  /// How far it is to the first panel along sixteen paths [lengths of the path]; 1: none on the way.
  void free_shares(const PathPacket& paths, Floats& shares) const;

 private:
  struct Embree;
  std::shared_ptr<const Embree> embree_;
};

}  // namespace aisle
