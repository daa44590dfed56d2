#pragma once

#include <optional>
#include <span>

#include "aisle/learning/walls/wall_heading.hpp"
#include "aisle/maps/wall_direction.hpp"

namespace aisle {

/// The direction of the walls around on the map, modulo a right angle. Where the vehicle's heading is known,
/// it gives this direction; where it is not, this direction gives the heading.
class WallCompass {
 public:
  /// Forgets everything seen so far.
  /// @param walls  direction of the walls around, if known
  void start(const std::optional<WallDirection>& walls = {});

  /// The vehicle moved: the direction becomes less sure, as walls and map are not quite straight.
  void move(double path_m, double turn_rad);

  /// Compares the floor edges (base_link) in one image with the known walls. Walls that run in another
  /// direction for long become the known ones. Images taken near each other show the same edges with the same
  /// errors: the less the vehicle has moved since the last image, the less this one says, and nothing if it
  /// stands.
  /// @param heading_rad  of the vehicle on the map, as known without this image's edges
  void look(std::span<const SensedSegment> edges, double heading_rad, double sigma_rad);

  /// The vehicle's heading relative to the walls by the last image, near the given heading less their
  /// direction; nullopt if none was seen in the known direction.
  const std::optional<HeadingMeasurement>& against_walls() const { return against_walls_; }

  /// The vehicle's heading on the map by the last image; nullopt as above, and if the given heading is surer
  /// than the walls' direction.
  std::optional<HeadingMeasurement> heading() const;

  /// Learns the walls' direction from this heading at the last image, as far as it is sure.
  void learn(double heading_rad, double sigma_rad);

  double walls_rad() const { return walls_rad_; }  ///< in the map
  int starts() const { return starts_; }           ///< how often other walls became the known ones

 private:
  double walls_rad_ = 0, variance_ = 0;
  int starts_ = 0;               ///< 0: none are known
  int unlike_ = 0;               ///< images since walls were last seen in the known direction
  double new_share_ = 1;         ///< share of the next image's errors that is new: 0 .. 1
  double heading_variance_ = 0;  ///< as given with the last image
  std::optional<HeadingMeasurement> against_walls_;
};

}  // namespace aisle
