#include "aisle/missions/sections/section_driver.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/changed_parameters.hpp"
#include "aisle/missions/landmarks/landmark_run.hpp"
#include "aisle/missions/route_name.hpp"
#include "aisle/missions/route_rules.hpp"

namespace aisle {
namespace {

Result<Route> find_section_route(const Building& building, const std::string& name) {
  auto route = find_route(building, name);
  if (route && route->sections.empty())
    return Problem{{"", 0, "route"},
                   fmt::format("'{}' has no sections: it was learned by another method", name)};
  return route;
}

SectionRun run_of(const SessionOrigin& origin, bool and_back) {
  if (and_back) return SectionRun::kThereAndBack;
  return origin.in_reverse ? SectionRun::kBack : SectionRun::kThere;
}

}  // namespace

Problems unfit_for_sections(const VehicleDescription& vehicle) {
  Problems problems;
  if (vehicle.cameras.empty())
    problems.push_back({{"", 0, "cameras"}, "there is none: nothing can be followed"});
  if (!vehicle.is_differential)
    problems.push_back({{"", 0, "is_differential"}, "is false: sections need turns on the spot"});
  return problems;
}

Result<std::unique_ptr<SectionNavigator>> make_section_navigator(const SessionOrigin& origin,
                                                                 const VehicleDescription& vehicle) {
  auto building = parse_building(origin.building, "building");
  if (!building) return building.problems();
  SectionDriverParams params;
  Problems problems = assign_all(params, origin.parameters);
  for (Problem& problem : unfit_for_sections(vehicle)) problems.push_back(std::move(problem));
  auto route = find_section_route(*building, origin.route);
  if (!route) problems.insert(problems.end(), route.problems().begin(), route.problems().end());
  if (!problems.empty()) return problems;
  GuidedPath guided =
      guided_path(route->sections, route->path.at(0).T_map_path, run_of(origin, params.and_back));
  problems = check_floor_rules(*building, origin.route, guided.path, vehicle.footprint);
  if (!problems.empty()) return problems;
  return std::make_unique<SectionNavigator>(params.navigator, vehicle, corridor_camera(vehicle).name,
                                            route->sections, std::move(guided),
                                            FloorRules(*building, vehicle));
}

}  // namespace aisle
