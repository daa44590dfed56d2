#pragma once

#include <random>
#include <vector>

#include "physics.hpp"

namespace robots {

/// A level range scanner all around, at the site `laser`. It measures all of a scan at one moment.
class RangeScanner {
 public:
  static constexpr double kFirstAngle_rad = -std::numbers::pi;
  static constexpr double kRangeMin_m = 0.05;

  RangeScanner(int beams, double range_max_m, unsigned seed);

  /// Counter-clockwise from the rear, in metres; infinity where there is nothing within range.
  std::vector<float> scan(const Physics& physics);

  double angle_step_rad() const { return 2 * std::numbers::pi / beams_; }
  double range_max_m() const { return range_max_m_; }

 private:
  int beams_;
  double range_max_m_;
  std::mt19937_64 random_;
  std::normal_distribution<double> noise_m_{0, 0.01};
};

}  // namespace robots
