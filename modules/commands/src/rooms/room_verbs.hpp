#pragma once
/// The verbs of learning and driving with `--method route` (L96).

#include "aisle/commands/learn.hpp"
#include "aisle/commands/navigate.hpp"
#include "aisle/commands/trial.hpp"
#include "rooms/room_driver.hpp"
#include "rooms/room_learning_result.hpp"
#include "rooms/room_look.hpp"

namespace aisle {

Result<Outcome> learn_by_route(const LearnOptions& options, const RoomLearnerParams& params,
                               Console& console);
Result<Outcome> navigate_by_route(const NavigateOptions& options, const RoomDriverParams& params,
                                  Console& console);

/// How much a room changes between teaching and driving.
struct RoomChange {
  double furniture_m = 0.2;  ///< displacement of each piece, at most, along x and along y
  double light_share = 0.3;

  void describe(FieldList& fields) {
    fields.real("furniture_m", furniture_m, {0, 2}, "greatest displacement of each piece, along x and y");
    fields.real("light_share", light_share, {0, 0.95}, "greatest change of the light, up or down");
  }
};

struct RoomTrialParams {
  RoomLearnerParams learner;
  bool view_pattern = false;
  RoomNavigatorParams navigator;
  RoomLook look;
  RoomChange change;
  RoomChange park_change{.furniture_m = 0, .light_share = 0};

  void describe(FieldList& fields) {
    fields.group("learner", learner);
    fields.flag("view_pattern", view_pattern, "the scripted person shows the 63 views around a taught place");
    fields.group("navigator", navigator);
    fields.group("look", look);
    fields.group("change", change);
    fields.group("park_change", park_change);
  }
};

/// `trial route`: routes of a world with moved furniture and changed light.
Result<Outcome> trial_by_route(const TrialOptions& options, const RoomTrialParams& params, Console& console);
/// `trial turnings`: the thirteen turnings, each in its own room, or pairs that are too close.
Result<Outcome> trial_of_turnings(const TrialOptions& options, const RoomTrialParams& params,
                                  Console& console);
/// `trial park`: parking at the ends of routes, from disturbed starts.
Result<Outcome> trial_of_parking(const TrialOptions& options, const RoomTrialParams& params,
                                 Console& console);

}  // namespace aisle
