#pragma once

#include <optional>
#include <span>

#include "aisle/learning/walls/wall_heading.hpp"
#include "aisle/maps/wall_direction.hpp"

namespace aisle {

/// Which way the walls around run on the map, modulo a right angle. Where the vehicle's heading is known it
/// tells this; where it is not, this tells the heading.
class WallCompass {
 public:
  /// Nothing that was seen so far counts. @param walls  around, if known
  void start(const std::optional<WallDirection>& walls = {});

  /// The vehicle drove so far and turned: walls and map are not quite straight.
  void move(double path_m, double turn_rad);

  /// Compares the edges of the floor (base_link) in one image with the walls that are known. Walls that run
  /// otherwise for long become those that are known. Images from near each other show the same edges with
  /// the same errors: the less the vehicle has moved since the last one, the less this one tells, and nothing
  /// if it stands.
  /// @param heading_rad  of the vehicle on the map, as far as known without this image's edges
  void look(std::span<const SensedSegment> edges, double heading_rad, double sigma_rad);

  /// The vehicle's heading against the walls by the last image, near the heading that was given less their
  /// direction; nullopt where none was seen that runs as known.
  const std::optional<HeadingMeasurement>& against_walls() const { return against_walls_; }

  /// The vehicle's heading on the map by the last image; nullopt the same, and where the heading that was
  /// given is surer than the walls' direction.
  std::optional<HeadingMeasurement> heading() const;

  /// Takes this heading, of the last image, for true, as far as it is sure.
  void learn(double heading_rad, double sigma_rad);

  double walls_rad() const { return walls_rad_; }  ///< in the map
  int starts() const { return starts_; }           ///< how often other walls became those that are known

 private:
  double walls_rad_ = 0, variance_ = 0;
  int starts_ = 0;               ///< 0: none is known
  int unlike_ = 0;               ///< images since walls last ran as known
  double again_ = 1;             ///< how much of the next image's errors are new ones: 0 .. 1
  double heading_variance_ = 0;  ///< as given with the last image
  std::optional<HeadingMeasurement> against_walls_;
};

}  // namespace aisle
