#pragma once

namespace robots {

struct ImageSize {
  int width_px = 0;
  int height_px = 0;
};

}  // namespace robots
