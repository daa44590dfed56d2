#pragma once

#include <vector>

#include "aisle/vehicle/camera_description.hpp"

namespace aisle {

/// Where each pixel of a camera looks, computed once.
struct LensTable {
  struct Slopes {
    float x = 0, y = 0;                                    ///< of the pixel's middle; direction (x, y, 1)
    float x_by_u = 0, x_by_v = 0, y_by_u = 0, y_by_v = 0;  ///< to the next pixels
  };

  int width_px = 0, height_px = 0;
  std::vector<Slopes> slopes;
  std::vector<float> transmission;  ///< share of the light that the lens lets through; 0: no ray at all

  LensTable(const CameraDescription& camera, double vignetting);

  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(u);
  }
};

}  // namespace aisle
