#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "image_size.hpp"
#include "physics.hpp"

namespace robots {

/// Draws what the model's cameras see, without a screen: EGL, Mesa's software renderer will do.
class OffscreenView {
 public:
  /// Throws std::runtime_error where nothing can be drawn.
  explicit OffscreenView(const Physics& physics);
  ~OffscreenView();
  OffscreenView(const OffscreenView&) = delete;
  OffscreenView& operator=(const OffscreenView&) = delete;

  /// @param camera its name in the model
  /// @return red, green and blue of each pixel, by rows from the top
  std::vector<std::uint8_t> draw(const Physics& physics, const char* camera, const ImageSize& size);

 private:
  class Egl;

  std::unique_ptr<Egl> egl_;
  mjvScene scene_;
  mjrContext context_;
};

}  // namespace robots
