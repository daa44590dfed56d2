#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Where a vehicle could not go on, as something was in the path that the floor does not show.
class BlockMemory {
 public:
  /// It was stopped here while it drove forwards (1) or backwards (-1), or touched as it stood (0).
  void note(const Pose2& T_map_vehicle, int direction);

  /// Whether it was stopped there last, or about there.
  bool was_at(const Pose2& T_map) const;
  /// Forwards (1) or backwards (-1): the path on from there must not begin so. 0: it may begin either way.
  int shut_direction() const { return shut_direction_; }
  /// There is no other path on.
  void open_direction() { shut_direction_ = 0; }
  /// So often on end, about there.
  int times() const { return times_; }

  /// A path through this pose would be stopped again: it lies just beyond one where the vehicle was.
  bool is_barred(const Pose2& T_map) const;
  /// For another target, or knowing more, all may be tried again.
  void unbar() { T_map_barred_.clear(); }

 private:
  Vec2 p_map_ = Vec2::Constant(1e9);
  int shut_direction_ = 0;
  int times_ = 0;
  std::vector<Pose2> T_map_barred_;
};

}  // namespace aisle
