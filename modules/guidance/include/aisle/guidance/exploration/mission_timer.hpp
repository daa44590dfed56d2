#pragma once

#include <optional>

namespace aisle {

/// How long a mission has run, and for how long its vehicle has got nowhere.
class MissionTimer {
 public:
  /// @param time_max_s  for the whole mission
  /// @param stuck_s     for getting nowhere
  MissionTimer(double time_max_s, double stuck_s) : time_max_s_(time_max_s), stuck_s_(stuck_s) {}

  /// Once a cycle, first.
  void tick(double stamp_s) {
    now_s_ = stamp_s;
    if (!begun_s_) begun_s_ = progress_s_ = stamp_s;
  }
  /// The vehicle drives, or has settled something where it stands.
  void note_progress() { progress_s_ = now_s_; }

  double now_s() const { return now_s_; }
  double since_begin_s() const { return now_s_ - begun_s_.value_or(now_s_); }
  bool is_over() const { return since_begin_s() > time_max_s_; }
  bool is_stuck() const { return now_s_ - progress_s_ > stuck_s_; }

 private:
  double time_max_s_;
  double stuck_s_;
  std::optional<double> begun_s_;
  double now_s_ = 0;
  double progress_s_ = 0;
};

}  // namespace aisle
