#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "aisle/learning/landmarks/landmark_expectation.hpp"

namespace aisle {

/// Notices that hardly any of the landmarks that should be seen is, image after image: where much is in
/// view something fits somehow everywhere, and a lifted vehicle would go on by that. It is noticed the sooner
/// where most of them were seen until then.
class ExpectationMonitor {
 public:
  /// Nothing that was seen so far counts.
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
  static constexpr std::size_t kAtOnce = 4;   ///< images, after kPictures others that showed most
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
