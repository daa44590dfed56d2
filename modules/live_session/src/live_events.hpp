#pragma once

#include <cstddef>
#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/geometry/pose2.hpp"
#include "goal_events.hpp"

namespace aisle {

/// What happened in a mission, for its timeline: new states of the navigator, marks, bumper contacts and what
/// became of its goals, from the messages of the mission, and what clients did.
class LiveEvents {
 public:
  static constexpr std::size_t kEventsMax = 1000;  ///< the oldest go first
  static constexpr std::size_t kTextMax = 200;     ///< bytes; longer texts are cut

  /// A mission or a session begins: nothing has happened yet.
  /// @param first  from which stamps are told
  void begin(ros::Stamp_ns first = 0);

  /// @param p_map_vehicle  where the vehicle is; nullopt: unknown
  void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr,
            const std::optional<Vec2>& p_map_vehicle);
  /// Adds what has become of the goals since they were told last.
  /// @param goals_json  a message of /goals
  void take_goals(ros::Stamp_ns stamp, const std::string& goals_json,
                  const std::optional<Vec2>& p_map_vehicle);
  void add(ros::Stamp_ns stamp, const char* kind, std::string_view text,
           const std::optional<Vec2>& p_map_vehicle);

  /// All that happened in this mission, also what is no longer kept.
  std::size_t count() const { return left_out_ + events_.size(); }

  /// {"from": 12, "events": [...]}, see docs/reference/live-server.md: those after the first `from` events.
  nlohmann::ordered_json json(std::size_t from) const;

 private:
  struct Event {
    ros::Stamp_ns stamp = 0;
    const char* kind = "";
    std::string text;
    std::optional<Vec2> p_map;
  };

  ros::Stamp_ns first_ = 0;
  std::deque<Event> events_;
  std::size_t left_out_ = 0;
  std::string state_;
  bool has_contact_ = false;
  MissionGoals goals_;
};

}  // namespace aisle
