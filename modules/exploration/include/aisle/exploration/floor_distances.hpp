#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "aisle/maps/known_floor.hpp"

namespace aisle {

/// Path lengths over known free floor, for a round vehicle, between one place and all others.
class FloorDistances {
 public:
  static constexpr float kUnreached = std::numeric_limits<float>::infinity();

  /// Which way the paths are driven. It matters where the floor is one-way.
  enum class Paths { kFromStart, kToStart };

  /// @param clearance_m  > 0, clearance that the vehicle's centre needs. A vehicle that is not round may
  /// start
  ///                with less: within `leeway_m` of the start it is not required.
  void measure(const KnownFloor& floor, const Vec2& from_m, double clearance_m, double leeway_m,
               Paths paths = Paths::kFromStart);

  /// The one place.
  FloorCell start() const { return start_; }
  /// [m]; kUnreached where no path is known. Diagonal steps count 1 % less than they are long.
  float to(FloorCell cell) const {
    const std::int32_t tenths = box_.contains(cell) ? tenths_[index(cell)] : kShut;
    return tenths == kShut || tenths == kFar ? kUnreached : static_cast<float>(tenths) * 0.1F * cell_m_;
  }
  /// To the nearest reached cell within a distance of a place [m].
  float near(const FloorGrid& floor, const Vec2& p_map, double within_m) const;

 private:
  static constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();
  /// Too little clearance: nearer than anything, so that no path leads there.
  static constexpr std::int32_t kShut = -1;
  static constexpr std::size_t kBuckets = 16;

  std::size_t index(FloorCell cell) const {
    return static_cast<std::size_t>(cell.y - box_.low.y) * static_cast<std::size_t>(box_.end.x - box_.low.x) +
           static_cast<std::size_t>(cell.x - box_.low.x);
  }

  struct Reached {
    std::uint32_t at;  ///< a cell's index ...
    std::uint8_t by;   ///< ... and the step that led there
  };

  std::size_t next(std::size_t at, unsigned step) const {
    return at + static_cast<std::size_t>(to_next_[step]);
  }
  void begin_at(std::size_t start);
  template <class Leave>
  void settle(std::int32_t until, Leave leave);
  void go(std::size_t from, unsigned step);
  void go_on(Reached reached);
  void go_where_allowed(const KnownFloor& floor, Reached reached, Paths paths);

  FloorBox box_;
  FloorCell start_;
  float cell_m_ = 0;
  std::vector<std::int32_t> tenths_;  ///< from the start to each cell of the box, in tenths of a cell
  std::array<std::ptrdiff_t, 8> to_next_ = {};        ///< what each step adds to a cell's index
  std::array<std::vector<Reached>, kBuckets> queue_;  ///< scratch memory, like the members below
  std::vector<Reached> bucket_;
  std::int32_t now_ = 0;
  std::size_t waiting_ = 0;
};

}  // namespace aisle
