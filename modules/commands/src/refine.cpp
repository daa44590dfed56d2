#include "aisle/commands/refine.hpp"

#include "aisle/commands/known_building.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "refining/refine_methods.hpp"

namespace aisle {

Outcome refine_parameters() {
  RefineParams params;
  return parameter_listing("refine", fields_of(params));
}

Result<Outcome> run_refine(const RefineOptions& options, Console& console) {
  RefineParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  auto building = read_known_building(options.building, console);
  if (!building) return building.problems();
  if (!building->landmarks.empty())
    return refine_landmark_building(options, params.landmarks, std::move(*building), console);
  return refine_wall_building(options, params.walls, std::move(*building), console);
}

}  // namespace aisle
