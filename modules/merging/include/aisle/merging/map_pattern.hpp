#pragma once

#include <cstdint>
#include <vector>

#include "aisle/localisation/surface_field.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

/// A short piece of a wall face.
struct WallSample {
  Vec2 p_map = Vec2::Zero();    ///< its middle
  Vec2 normal = Vec2::UnitX();  ///< unit, towards the free side
  double length_m = 0;
  bool begins_wall = false;  ///< else it goes on from the piece before
};

/// What a map says of a wall face at some place.
enum class MapOpinion {
  kConfirmed,  ///< it has that face, too
  kDenied,     ///< it has seen free floor there
  kSilent,     ///< it has not seen the place, or something else is too near to tell
};

/// One map as it is compared with others: its walls in short pieces, and what it says of the walls of others.
/// Only a map with a floor denies anything. O(cells) to make; every question O(1).
class MapPattern {
 public:
  static constexpr double kSample_m = 0.2;   ///< length of a piece
  static constexpr double kSame_m = 0.15;    ///< faces nearer than this are one
  static constexpr double kBeyond_m = 0.25;  ///< free floor this far from everything denies a wall

  /// @throws std::invalid_argument if the building has neither walls nor occupied floor, or is too large
  explicit MapPattern(const Building& building);

  const std::vector<WallSample>& samples() const { return samples_; }
  double wall_m() const { return wall_m_; }
  const SurfaceField& field() const { return field_; }

  /// The face of a wall nearest to a place that looks the same way; null: none within reach.
  const Surface* facing_wall(const Vec2& p_map, const Vec2& normal) const;
  /// @param beyond_m  free floor this far from everything denies the wall
  MapOpinion opinion_of(const Vec2& p_map, const Vec2& normal, double beyond_m = kBeyond_m) const;
  /// The face of a wall that is, as far as two maps agree, the one at this place; null: there are at most
  /// cells.
  const Surface* same_wall(const Vec2& p_map, const Vec2& normal) const;

 private:
  SurfaceField field_;
  std::vector<WallSample> samples_;
  double wall_m_ = 0;
};

/// How far two maps agree where both have seen the building, at one placement.
struct MapOverlap {
  double common_m = 0;         ///< length of the walls that both have; the mean of both sides' counts
  double denied_m = 0;         ///< walls of either where the other saw free floor
  double denied_run_m = 0;     ///< of these, the longest in one piece
  Mat2 spread = Mat2::Zero();  ///< sum of n n^T dl over the common walls, in the fixed map [m]

  /// Share of the walls in sight of both that both have; 0 if there are none.
  double agreement() const { return common_m > 0 ? common_m / (common_m + denied_m) : 0; }
  /// Length of common walls that fixes the worse known of all directions [m].
  double fixing_m() const;
  /// Common walls, less what speaks against them.
  double score_m() const;
};

MapOverlap overlap_of(const MapPattern& fixed, const MapPattern& moved, const Pose2& T_fixed_moved);

}  // namespace aisle
