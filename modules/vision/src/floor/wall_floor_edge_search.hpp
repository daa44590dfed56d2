#pragma once

#include <optional>
#include <span>
#include <vector>

#include "floor/wall_floor_edge.hpp"
#include "floor/wall_floor_edge_evidence.hpp"
#include "lines/oblique_segments.hpp"

namespace aisle {

/// Searches a side view for the right wall's wall-floor edge.
class WallFloorEdgeSearch {
 public:
  /// @param segments  turned into the view
  /// @return the best line, or the lower edge of its board; nullopt if none scores `score_min`
  std::optional<WallFloorEdge> find(const SideScene& scene, std::span<const EdgeSegment> segments,
                                    double score_min);

 private:
  struct Seed {
    Vec2 point_px, direction;
    double length_px;
  };
  struct Scatter;

  void gather_rays(const SideScene& scene, std::span<const EdgeSegment> segments);
  void gather_seeds(const SideScene& scene);
  std::optional<WallFloorEdge> fitted(const SideScene& scene, const Seed& seed);
  Scatter take_near(const SideScene& scene, const WallFloorEdge& edge, double tolerance_px);
  void cover(double width_px, WallFloorEdge& edge);
  const WallFloorEdge* lowest_of_like_score(const SideScene& scene, double score_min) const;

  std::vector<EdgeSegment> rays_;  ///< segments that point to the vanishing point from the right below
  std::vector<Seed> seeds_;
  std::vector<std::pair<double, double>> near_px_;  ///< the rays on a line, from and to along it
  std::vector<WallFloorEdge> edges_;
};

}  // namespace aisle
