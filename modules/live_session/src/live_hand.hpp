#pragma once

#include <optional>
#include <vector>

#include "aisle/live/drive_command.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// Operator input of a person who drives through the live server.
class LiveHand {
 public:
  /// The vehicle stops if the newest command is older than this, by the vehicle's clock.
  static constexpr double kCommandAgeMax_s = 0.3;

  explicit LiveHand(DriveInbox& inbox) : inbox_(inbox) {}

  /// The current input. Called once per cycle.
  OperatorInput look(double stamp_s);

  void mark(Mark mark) { marks_.push_back(std::move(mark)); }
  /// The person ends the drive here.
  void finish() { is_finished_ = true; }
  /// While held, commands are ignored.
  void hold(bool held) { is_held_ = held; }

  /// The vehicle's clock stood still: drops the newest command, which may be old by real time.
  void forget_command() { newest_.reset(); }

  /// A drive begins: drops all earlier input.
  void begin();

 private:
  DriveInbox& inbox_;
  std::optional<DriveCommand> newest_;
  double heard_s_ = 0;  ///< when the newest command arrived, by the vehicle's clock
  std::vector<Mark> marks_;
  bool is_finished_ = false;
  bool is_held_ = false;
};

}  // namespace aisle
