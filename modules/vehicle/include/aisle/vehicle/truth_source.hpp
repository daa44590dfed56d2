#pragma once

#include <cstddef>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// What really happened so far: for evaluation and viewers, never for a navigator.
struct Truth {
  double stamp_s = 0;
  Pose2 T_world_vehicle;
  double speed_mps = 0;  ///< of base_link, forwards
  double turn_rate_rad_s = 0;
  double path_m = 0;           ///< distance that base_link has travelled, forwards and backwards
  std::size_t collisions = 0;  ///< how often it has hit something
};

/// Knows the truth of a vehicle. Only a simulated vehicle has one.
class TruthSource {
 public:
  virtual ~TruthSource() = default;

  virtual const Truth& truth() const = 0;
};

/// Whether a vehicle is simulated, by its source of truth; null: it has none.
inline bool is_simulated(const TruthSource* truth) {
  return truth != nullptr;
}

}  // namespace aisle
