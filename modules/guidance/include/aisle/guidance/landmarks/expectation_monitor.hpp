#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "aisle/learning/landmarks/landmark_expectation.hpp"

namespace aisle {

/// Detects kidnapping when image after image shows hardly any of the landmarks that should be in view. Where
/// much is in view, something fits everywhere, and a kidnapped vehicle would go on by that. Detection is
/// faster if most landmarks were seen until then.
class ExpectationMonitor {
 public:
  /// Forgets what was seen so far.
  void start() { *this = {}; }

  /// Takes in what one image should show.
  /// @return whether the latest images together show fewer than one in ten of many expected landmarks
  bool look(std::span<const ExpectedLandmark> expected) {
    std::copy_backward(images_.begin(), images_.end() - 1, images_.end());
    const auto seen = std::count_if(expected.begin(), expected.end(),
                                    [](const ExpectedLandmark& landmark) { return landmark.is_seen; });
    images_.front() = {static_cast<int>(expected.size()), static_cast<int>(seen)};
    const Tally before = in_images(kAtOnce, kAtOnce + kImages);
    const bool were_seen = before.expected >= kExpectedAtOnce && 2 * before.seen >= before.expected;
    return are_missing(in_images(0, kImages), kExpectedLeast) ||
           (were_seen && are_missing(in_images(0, kAtOnce), kExpectedAtOnce));
  }

 private:
  static constexpr std::size_t kImages = 10;
  static constexpr std::size_t kAtOnce = 4;   ///< images, after kImages others that showed most
  static constexpr int kExpectedLeast = 60;   ///< in all images together
  static constexpr int kExpectedAtOnce = 24;  ///< the same
  static constexpr int kSeenOneIn = 10;

  struct Tally {
    int expected = 0, seen = 0;
  };

  /// @param first  0: the latest
  Tally in_images(std::size_t first, std::size_t end) const {
    Tally all;
    for (std::size_t i = first; i < end; ++i) {
      all.expected += images_[i].expected;
      all.seen += images_[i].seen;
    }
    return all;
  }

  static bool are_missing(const Tally& all, int expected_least) {
    return all.expected >= expected_least && kSeenOneIn * all.seen < all.expected;
  }

  std::array<Tally, kAtOnce + kImages> images_{};  ///< the latest first
};

}  // namespace aisle
