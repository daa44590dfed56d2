#include "aisle/trials/reproduce.hpp"

#include <fmt/format.h>

#include "aisle/commands/parameter_listing.hpp"
#include "reproduced.hpp"

namespace aisle {
namespace {

struct ReproduceParams {
  LandmarkCourseParams landmarks;
  SectionTrialParams sections;

  void describe(FieldList& fields) {
    landmarks.describe(fields);
    fields.group("sections", sections);
  }
};

}  // namespace

Outcome reproduce_parameters() {
  ReproduceParams params;
  return parameter_listing("reproduce", fields_of(params));
}

Result<Outcome> run_reproduce(const ReproduceOptions& options, Console& console) {
  ReproduceParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (options.experiment == "c98") return reproduce_c98(options, params.landmarks, console);
  if (options.experiment == "c99") return reproduce_c99(options, console);
  if (options.experiment == "l03") return reproduce_l03(options, params.sections, console);
  return Problem{{"EXPERIMENT"},
                 fmt::format("'{}' is unknown; there are: c98, c99, l03", options.experiment)};
}

}  // namespace aisle
