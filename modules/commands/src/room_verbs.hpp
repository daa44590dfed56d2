#pragma once
/// The verbs of learning and driving with `--method route` (L96).

#include "aisle/commands/learn.hpp"
#include "aisle/commands/navigate.hpp"
#include "aisle/commands/trial.hpp"
#include "room_driver.hpp"
#include "room_lesson.hpp"

namespace aisle {

Result<Outcome> learn_by_route(const LearnOptions& options, const RoomLessonParams& params, Console& console);
Result<Outcome> navigate_by_route(const NavigateOptions& options, const RoomDriverParams& params,
                                  Console& console);

struct RoomTrialParams {
  RoomLessonParams lesson;
  RoomNavigatorParams navigator;

  void describe(FieldList& fields) {
    fields.group("lesson", lesson);
    fields.group("navigator", navigator);
  }
};

/// `trial route`: routes of a world with their furniture moved and other light.
Result<Outcome> trial_by_route(const TrialOptions& options, const RoomTrialParams& params, Console& console);
/// `trial turnings`: the thirteen turnings, each in a room of its own.
Result<Outcome> trial_of_turnings(const TrialOptions& options, const RoomTrialParams& params,
                                  Console& console);
/// `trial park`: the ends of routes, from disturbed starts.
Result<Outcome> trial_of_parking(const TrialOptions& options, const RoomTrialParams& params,
                                 Console& console);

}  // namespace aisle
