#pragma once
/// The two ways of `aisle refine`.

#include "aisle/commands/refine.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/localisation/localiser.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/merging/building_refinement.hpp"
#include "aisle/missions/landmarks/landmark_learning_result.hpp"

namespace aisle {

struct WallRefinerParams {
  LocaliserParams localiser;
  RefinementParams refinement;

  void describe(FieldList& fields) {
    fields.group("localiser", localiser);
    fields.group("refinement", refinement);
  }
};

struct RefineParams {
  LandmarkLearnerParams landmarks;
  WallRefinerParams walls;

  void describe(FieldList& fields) {
    landmarks.describe(fields);
    walls.describe(fields);
  }
};

/// With sessions along the building's routes.
Result<Outcome> refine_landmark_building(const RefineOptions& options, const LandmarkLearnerParams& params,
                                         Building building, Console& console);

/// With recordings of a laser scanner.
Result<Outcome> refine_wall_building(const RefineOptions& options, const WallRefinerParams& params,
                                     Building building, Console& console);

}  // namespace aisle
