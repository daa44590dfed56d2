#pragma once

#include <cstdint>
#include <vector>

namespace aisle {

/// A square image of brightnesses 0 to 1 that repeats for ever, kept at half, quarter, ... resolution along
/// each axis separately, so that a pixel that sees much of one axis and little of the other is filtered
/// right.
class Texture {
 public:
  static constexpr int kSide = 256;
  static constexpr int kLevels = 9;  ///< kSide texels down to one

  using Image = std::vector<float>;  ///< kSide rows of kSide

  explicit Texture(const Image& image);

  /// Where a level begins along an axis of the store, which is 2 kSide long.
  static constexpr int level_begin(int level) { return 2 * kSide - (2 * kSide >> level); }

  /// A texel with its neighbours to the right, below, and right below: a byte each, the lowest first.
  const std::uint32_t* store() const { return store_.data(); }

 private:
  void keep(const Image& image, int level_x, int level_y);

  std::vector<std::uint32_t> store_;
};

}  // namespace aisle
