#pragma once

#include <optional>
#include <vector>

#include "aisle/control/path.hpp"

namespace aisle {

/// Remembers where the vehicle was stopped by something that the floor map does not show.
class BlockMemory {
 public:
  /// The vehicle was stopped here while driving in a direction, or touched while standing (nullopt).
  void note(const Pose2& T_map_vehicle, std::optional<LegDirection> direction);

  /// Whether it was last stopped there or close by.
  bool was_at(const Pose2& T_map) const;
  /// The next path from there must not begin in this direction; nullopt: it may begin in any.
  std::optional<LegDirection> blocked_direction() const { return blocked_direction_; }
  /// There is no other path: it may begin in any direction again.
  void unblock_direction() { blocked_direction_.reset(); }
  /// How many times in a row it was stopped on that spot.
  int times() const { return times_; }

  /// Whether a path through this pose would be stopped again: it lies just beyond a pose where the vehicle
  /// was stopped.
  bool is_barred(const Pose2& T_map) const;
  /// With another target, or when more is known, all poses may be tried again.
  void unbar() { T_map_barred_.clear(); }

 private:
  Vec2 p_map_ = Vec2::Constant(1e9);
  std::optional<LegDirection> blocked_direction_;
  int times_ = 0;
  std::vector<Pose2> T_map_barred_;
};

}  // namespace aisle
