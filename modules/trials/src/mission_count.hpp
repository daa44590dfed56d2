#pragma once

#include <cstddef>
#include <string_view>

#include "aisle/core/progress.hpp"

namespace aisle {

/// Shows how many of several missions are finished instead of the progress within the current one, which can
/// still be interrupted.
class MissionCount final : public Progress {
 public:
  /// @param what  shown label: "missions", "runs"
  MissionCount(Progress& shown, std::string_view what, std::size_t missions)
      : shown_(shown), what_(what), missions_(missions) {}

  void begin(std::size_t finished) {
    finished_ = finished;
    shown_.report(what_, finished_, missions_);
  }
  void report(std::string_view, std::size_t, std::size_t) override {
    shown_.report(what_, finished_, missions_);
  }

 private:
  Progress& shown_;
  std::string_view what_;
  std::size_t missions_;
  std::size_t finished_ = 0;
};

}  // namespace aisle
