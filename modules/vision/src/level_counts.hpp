#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace aisle {

/// How often each grey level, or size of a difference of two, is there.
class LevelCounts {
 public:
  void add(std::uint8_t level) {
    ++counts_[level];
    ++count_;
  }

  /// 0 where nothing was added.
  int median() const {
    std::size_t level = 0;
    for (std::size_t below = counts_[0]; 2 * below < count_; below += counts_[level]) ++level;
    return static_cast<int>(level);
  }

 private:
  std::array<std::size_t, 256> counts_{};
  std::size_t count_ = 0;
};

}  // namespace aisle
