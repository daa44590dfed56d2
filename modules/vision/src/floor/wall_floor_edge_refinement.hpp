#pragma once

#include <array>
#include <vector>

#include "floor/side_view.hpp"
#include "floor/wall_floor_edge.hpp"

namespace aisle {

/// Shifts and turns a wall-floor edge within a few pixels to where the image steps most along its whole
/// length: each pair of offsets at its two ends is tried. Of two that are nearly equal, such as the edges of
/// a skirting board, the lower one is taken.
class WallFloorEdgeRefinement {
 public:
  /// @param from_px, to_px  the part of the line that is in the image, along its direction
  void refine(const SideView& view, double from_px, double to_px, WallFloorEdge& edge);

 private:
  struct Shift {
    std::size_t at_from = 0, at_to = 0;  ///< steps across, of which the middle one is no shift
    std::size_t side = 0;                ///< 0: the floor is brighter than what stands on it
    double votes = 0;
    bool other_edge = false;  ///< of the board, beneath the line that was found
  };

  using Shifts_px = std::pair<double, double>;  ///< at both ends

  void measure_steps(const SideView& view, double from_px, double to_px, const WallFloorEdge& edge);
  void sample_profiles(const SideView& view, double from_px, double to_px, const WallFloorEdge& edge);
  void average_profile(std::size_t i);
  void thin(std::vector<float>& steps) const;
  void vote(std::size_t side, bool other_edge);
  const Shift* most_voted() const;
  const Shift* lowest_of_like_votes() const;
  Shifts_px settled(const Shift& shift) const;
  Shifts_px between_steps(const Shifts_px& shifts_px, std::size_t side) const;
  static void move(const Shifts_px& shifts_px, double from_px, double to_px, WallFloorEdge& edge);

  std::size_t reach_ = 0, across_ = 0, along_ = 0;
  std::vector<float> profiles_;              ///< brightness across the line, one after the other along it
  std::vector<float> profile_;               ///< one of them, averaged
  std::array<std::vector<float>, 2> steps_;  ///< of each sign; one row of `across_` a sample
  std::array<std::vector<float>, 2> edges_;  ///< the same from pixel to pixel, sharper
  std::vector<Shift> shifts_;
};

}  // namespace aisle
