#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "aisle/wire/wire.hpp"
#include "command_messages.hpp"

namespace aisle {

/// Sends commands to a robot at 20 Hz, whatever the mission does: robots stop without, and some do not even
/// then. The latest command is sent until it is too old, ever slower once the next one is late; then, while
/// held, and ten times at the end: stop.
/// What gets faster does so within the vehicle's limits; what gets slower does so at once.
class CommandOutlet {
 public:
  static constexpr double kPeriod_s = 0.05;
  static constexpr int kStopsAtEnd = 10;

  struct Settings {
    CommandKind kind = CommandKind::kTwist;
    double age_max_s = 0.3;
    std::string frame;
  };

  /// @param now_s    the clock by which commands age
  /// @param stamp    the robot's time, for the kinds of commands that have a stamp
  CommandOutlet(std::unique_ptr<WirePublisher> publisher, Settings settings, VehicleDescription vehicle,
                std::function<double()> now_s, std::function<ros::Stamp_ns()> stamp);
  ~CommandOutlet();
  CommandOutlet(const CommandOutlet&) = delete;
  CommandOutlet& operator=(const CommandOutlet&) = delete;

  void act(const Command& command);
  /// While held, only stops are sent; commands from before do not come back.
  void hold(bool is_held);

  /// While silent, nothing is sent but the stops at the end.
  void fall_silent(bool is_silent);

  /// What was commanded so far: the commands that were sent, each for as long as it was the latest.
  Arc commanded();
  /// How often a stop replaced a command that had become too old while the vehicle was moving.
  std::size_t aged() const { return aged_; }

 private:
  void run();
  void send();
  void add_commanded(double now_s);
  double share_of(double age_s) const;
  Command present(double now_s);

  std::unique_ptr<WirePublisher> publisher_;
  Settings settings_;
  VehicleDescription vehicle_;
  std::function<double()> now_s_;
  std::function<ros::Stamp_ns()> stamp_;

  std::mutex mutex_;
  std::condition_variable wake_;
  Command wanted_;
  Command sent_;
  double wanted_at_s_ = 0;
  double sent_at_s_ = 0;
  Arc commanded_;
  bool is_held_ = false;
  bool is_silent_ = false;
  bool is_over_ = false;
  std::atomic<std::size_t> aged_ = 0;
  std::thread thread_;
};

}  // namespace aisle
