#include "aisle/commands/method.hpp"
#include "aisle/missions/landmarks/landmark_run.hpp"
#include "aisle/missions/sections/section_driver.hpp"
#include "sections/section_verbs.hpp"

namespace aisle {
namespace {

Problems prepare_for_sections(const TeachOptions&, const VehicleDescription& vehicle, DriveOptions& drive) {
  if (Problems problems = unfit_for_sections(vehicle); !problems.empty())
    return at_file(std::move(problems), drive.vehicle_file());
  drive.camera = corridor_camera(vehicle).name;
  return {};
}

}  // namespace

const Method kSectionMethod = {
    .name = "sections",
    .usual_vehicle = "mini",
    .learns_from_several = true,
    .learns_views = false,
    .prepare = prepare_for_sections,
    .learn = [](const LearnOptions& options, const LearnParams& params,
                Console& console) { return learn_by_sections(options, params.sections, console); },
    .navigate = [](const NavigateOptions& options, const NavigateParams& params,
                   Console& console) { return navigate_by_sections(options, params.sections, console); }};

}  // namespace aisle
