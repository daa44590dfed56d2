#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "aisle/learning/landmarks/landmark_expectation.hpp"

namespace aisle {

/// Notices that hardly any of the landmarks that should be seen is, picture after picture: where much is in
/// view something fits somehow everywhere, and a lifted vehicle would go on by that. It is noticed the sooner
/// where most of them were seen until then.
class ExpectationWatch {
 public:
  /// Nothing that was seen so far counts.
  void start() { *this = {}; }

  /// Takes in what one picture should show.
  /// @return whether the latest pictures together show fewer than one in ten of many expected landmarks
  bool look(std::span<const ExpectedLandmark> expected) {
    std::copy_backward(pictures_.begin(), pictures_.end() - 1, pictures_.end());
    const auto seen = std::count_if(expected.begin(), expected.end(),
                                    [](const ExpectedLandmark& landmark) { return landmark.is_seen; });
    pictures_.front() = {static_cast<int>(expected.size()), static_cast<int>(seen)};
    const Tally before = in_pictures(kAtOnce, kAtOnce + kPictures);
    const bool were_seen = before.expected >= kExpectedAtOnce && 2 * before.seen >= before.expected;
    return are_missing(in_pictures(0, kPictures), kExpectedLeast) ||
           (were_seen && are_missing(in_pictures(0, kAtOnce), kExpectedAtOnce));
  }

 private:
  static constexpr std::size_t kPictures = 10;
  static constexpr std::size_t kAtOnce = 4;   ///< pictures, after kPictures others that showed most
  static constexpr int kExpectedLeast = 60;   ///< in all pictures together
  static constexpr int kExpectedAtOnce = 24;  ///< likewise
  static constexpr int kSeenOneIn = 10;

  struct Tally {
    int expected = 0, seen = 0;
  };

  /// @param first  0: the latest
  Tally in_pictures(std::size_t first, std::size_t end) const {
    Tally all;
    for (std::size_t i = first; i < end; ++i) {
      all.expected += pictures_[i].expected;
      all.seen += pictures_[i].seen;
    }
    return all;
  }

  static bool are_missing(const Tally& all, int expected_least) {
    return all.expected >= expected_least && kSeenOneIn * all.seen < all.expected;
  }

  std::array<Tally, kAtOnce + kPictures> pictures_{};  ///< the latest first
};

}  // namespace aisle
