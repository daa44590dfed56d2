#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "aisle/learning/landmarks/landmark_expectation.hpp"

namespace aisle {

/// Notices that hardly any of the landmarks that should be seen is, picture after picture: where much is in
/// view something fits somehow everywhere, and a lifted vehicle would go on by that.
class ExpectationWatch {
 public:
  /// Nothing that was seen so far counts.
  void start() { *this = {}; }

  /// Takes in what one picture should show.
  /// @return whether the latest pictures together show fewer than one in ten of many expected landmarks
  bool look(std::span<const ExpectedLandmark> expected) {
    const auto seen = std::count_if(expected.begin(), expected.end(),
                                    [](const ExpectedLandmark& landmark) { return landmark.is_seen; });
    pictures_[count_++ % pictures_.size()] = {static_cast<int>(expected.size()), static_cast<int>(seen)};
    Tally all;
    for (const Tally& picture : pictures_) {
      all.expected += picture.expected;
      all.seen += picture.seen;
    }
    return all.expected >= kExpectedLeast && kSeenOneIn * all.seen < all.expected;
  }

 private:
  static constexpr int kExpectedLeast = 60;  ///< in all pictures together
  static constexpr int kSeenOneIn = 10;

  struct Tally {
    int expected = 0, seen = 0;
  };

  std::array<Tally, 10> pictures_{};
  std::size_t count_ = 0;
};

}  // namespace aisle
