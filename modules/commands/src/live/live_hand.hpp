#pragma once

#include <optional>
#include <vector>

#include "aisle/live/drive_command.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// A person who drives through the live server, as the vehicle's side hears them.
class LiveHand {
 public:
  /// Commands that are older, by the vehicle's time, mean: stop.
  static constexpr double kCommandAgeMax_s = 0.3;

  explicit LiveHand(DriveInbox& inbox) : inbox_(inbox) {}

  /// What they want now. Called once a cycle.
  OperatorInput look(double stamp_s);

  void mark(Mark mark) { marks_.push_back(std::move(mark)); }
  /// The drive ends here, as they wished.
  void finish() { is_finished_ = true; }
  /// While held no command is heard.
  void hold(bool held) { is_held_ = held; }

  /// Time stood still: what was said before is too old, however little of it has passed for the vehicle.
  void forget_command() { newest_.reset(); }

  /// A drive begins: nothing of before counts.
  void begin();

 private:
  DriveInbox& inbox_;
  std::optional<DriveCommand> newest_;
  double heard_s_ = 0;  ///< by the vehicle's time
  std::vector<Mark> marks_;
  bool is_finished_ = false;
  bool is_held_ = false;
};

}  // namespace aisle
