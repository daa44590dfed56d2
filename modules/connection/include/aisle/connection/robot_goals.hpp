#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// What people point at in a robot's viewer (RViz, Foxglove): goals on /goal_pose, and on /initialpose where
/// the robot stands. Both in the map's frame; what is not, or is no pose, is refused with the reason.
class RobotGoals {
 public:
  using Note = std::function<void(const std::string&)>;

  /// @param note  of what was refused; never empty; called by the takes
  static Result<std::unique_ptr<RobotGoals>> open(Wire& wire, const Connection& connection, Note note);

  explicit RobotGoals(Note note) : note_(std::move(note)) {}
  RobotGoals(const RobotGoals&) = delete;
  RobotGoals& operator=(const RobotGoals&) = delete;

  /// The newest one since the last such call.
  std::optional<Pose2> take_goal() { return take(goal_); }
  std::optional<Pose2> take_initial_pose() { return take(initial_); }

 private:
  /// What arrived on a topic and was not taken: a pose, or why it is none.
  struct Inbox {
    std::string topic;
    std::optional<Pose2> T_map;
    std::string refused;
  };

  template <class Message>
  Problems subscribe(Wire& wire, Inbox& inbox);
  std::optional<Pose2> take(Inbox& inbox);

  Note note_;
  std::mutex mutex_;
  Inbox goal_, initial_;
  std::vector<std::unique_ptr<WireSubscription>> subscriptions_;  ///< last: they end before what they fill
};

}  // namespace aisle
