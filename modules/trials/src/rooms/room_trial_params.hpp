#pragma once

#include "aisle/guidance/rooms/room_navigator.hpp"
#include "aisle/missions/rooms/room_learning_result.hpp"
#include "rooms/room_look.hpp"

namespace aisle {

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

}  // namespace aisle
