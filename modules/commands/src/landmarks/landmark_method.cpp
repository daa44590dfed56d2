#include "aisle/commands/method.hpp"
#include "aisle/missions/landmarks/landmark_run.hpp"
#include "landmarks/landmark_verbs.hpp"

namespace aisle {
namespace {

Problems prepare_for_landmarks(const TeachOptions&, const VehicleDescription& vehicle, DriveOptions& drive) {
  drive.camera = corridor_camera(vehicle).name;
  return {};
}

}  // namespace

const Method kLandmarkMethod = {
    .name = "landmarks",
    .usual_vehicle = "alv",
    .learns_from_several = false,
    .learns_views = false,
    .prepare = prepare_for_landmarks,
    .learn = [](const LearnOptions& options, const LearnParams& params,
                Console& console) { return learn_by_landmarks(options, params.landmarks, console); },
    .navigate = [](const NavigateOptions& options, const NavigateParams& params,
                   Console& console) { return navigate_by_landmarks(options, params.landmarks, console); }};

}  // namespace aisle
