#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/simulation/scenario.hpp"

namespace aisle {

/// What is wrong with one camera at a moment.
struct CameraTrouble {
  bool frozen = false;
  bool dark = false;
  bool dropped = false;
  double delay_s = 0;
};

/// Which events of a scenario are active.
class ScenarioPlay {
 public:
  explicit ScenarioPlay(Scenario scenario);

  /// Advances to `now_s`; events begin and end.
  void advance(double now_s, const Vec2& p_world_vehicle);

  std::size_t size() const { return events_.size(); }
  const Fault& fault(std::size_t event) const { return events_[event].event.fault; }
  bool is_on(std::size_t event) const { return events_[event].is_on; }

  double spin() const;
  double steering_bias_rad() const;
  bool laser_is_on() const;
  LightChange light() const;
  CameraTrouble trouble_of(std::string_view camera) const;

 private:
  struct PlayedEvent {
    ScenarioEvent event;
    std::optional<double> begun_s;
    bool is_on = false;
  };

  template <class Kind, class Use>
  void for_each_on(Use use) const;

  std::vector<PlayedEvent> events_;
};

}  // namespace aisle
