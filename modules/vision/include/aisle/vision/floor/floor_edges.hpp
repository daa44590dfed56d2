#pragma once
/// Where walls, doors and furniture meet the floor, in any direction, as seen by a camera whose mount is
/// known.

#include <memory>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

struct FloorEdgeParams {
  int columns = 160;
  double contrast_min = 5;
  double distance_max_m = 20;
  double length_min_m = 0.15;
  int looks_past = 0;
  double board_height_m = 0.16;
  BackProjectionNoise noise{.pixel_px = 0.3};

  void describe(FieldList& fields);
};

/// A straight edge of the floor.
struct FloorEdge {
  SensedSegment on_floor;        ///< in base_link; the camera lies on its left
  Vec2 start_px = Vec2::Zero();  ///< of the segment, (u, v) in the image
  Vec2 end_px = Vec2::Zero();
  double contrast = 0;  ///< brightness beyond the edge less that of the floor [grey levels]
};

/// Finds the lowest lasting step of brightness in every direction, and the straight lines along it. Joints
/// between tiles are no edges, as the floor beyond them looks the same. Where the upper edge of a skirting
/// board is clearer than its lower one, the lower one is taken. Where the floor lies in the shadow of what
/// stands on it, the edge is where that meets the floor, not where the shadow begins. No allocation once
/// warm; an image of 640 x 480 takes about a millisecond.
class FloorEdgeDetector {
 public:
  FloorEdgeDetector(const FloorEdgeParams& params, const CameraIntrinsics& intrinsics,
                    const CameraMount& mount);
  FloorEdgeDetector(FloorEdgeDetector&&) noexcept;
  ~FloorEdgeDetector();

  /// The edges of one image from left to right; valid until the next call.
  /// @throws std::invalid_argument unless the image has one channel
  const std::vector<FloorEdge>& detect(const Image& grey);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace aisle
