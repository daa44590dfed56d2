#pragma once

#include <string>

namespace aisle {

/// A room of `width` x `height` pixels behind walls one pixel thick.
inline std::string room_pbm(int width, int height) {
  std::string text = "P1\n" + std::to_string(width + 2) + " " + std::to_string(height + 2) + "\n";
  for (int y = 0; y < height + 2; ++y) {
    for (int x = 0; x < width + 2; ++x) {
      text += x == 0 || y == 0 || x == width + 1 || y == height + 1 ? '1' : '0';
    }
    text += '\n';
  }
  return text;
}

}  // namespace aisle
