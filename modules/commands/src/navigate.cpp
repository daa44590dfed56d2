#include "aisle/commands/navigate.hpp"

#include "aisle/commands/method.hpp"
#include "aisle/commands/parameter_listing.hpp"

namespace aisle {

Outcome navigate_parameters() {
  NavigateParams params;
  return parameter_listing("navigate", fields_of(params));
}

Result<Outcome> run_navigate(const NavigateOptions& options, Console& console) {
  const auto method = method_named(options.method, console);
  if (!method) return method.problems();
  NavigateParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (options.speed_mps)
    params.landmarks.speed.speed_mps = params.sections.navigator.speed.speed_mps =
        params.rooms.navigator.speed_mps = *options.speed_mps;
  params.sections.and_back = params.sections.and_back || options.and_back;
  return (*method)->navigate(options, params, console);
}

}  // namespace aisle
