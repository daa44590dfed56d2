#pragma once
/// The parameters of all methods, as the verbs list them: those of landmarks have no prefix.

#include "aisle/core/parameters.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"
#include "aisle/missions/landmarks/landmark_learning_result.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/missions/rooms/room_learning_result.hpp"
#include "aisle/missions/sections/section_driver.hpp"
#include "aisle/missions/sections/section_learning_result.hpp"

namespace aisle {

template <class Landmarks, class Sections, class Rooms>
struct MethodParams {
  Landmarks landmarks;
  Sections sections;
  Rooms rooms;

  void describe(FieldList& fields) {
    landmarks.describe(fields);
    fields.group("sections", sections);
    fields.group("rooms", rooms);
  }
};

using LearnParams = MethodParams<LandmarkLearnerParams, SectionLearnerParams, RoomLearnerParams>;
using NavigateParams = MethodParams<LandmarkNavigatorParams, SectionDriverParams, RoomDriverParams>;

}  // namespace aisle
