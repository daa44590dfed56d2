#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lines/oblique_segments.hpp"

namespace aisle {

/// The corridor's vanishing point: where most oblique segments point, weighted by length. Segments that fall
/// and segments that rise to the right must both take part; points near the middle of the image are
/// preferred.
/// @return nullopt if too few segments point to one place
class VanishingPointFinder {
 public:
  std::optional<Vec2> find(std::span<const EdgeSegment> segments, int width_px, int height_px);

 private:
  struct Voter {
    Vec2 middle_px, direction;
    double length_px;
    bool falls;  ///< to the right
  };

  void gather(std::span<const EdgeSegment> segments);
  double votes(const Vec2& point_px) const;
  Vec2 refined(Vec2 point_px) const;

  double width_px_ = 0, height_px_ = 0;
  std::vector<Voter> voters_;
};

}  // namespace aisle
