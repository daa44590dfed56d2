#include "aisle/trials/trial.hpp"

#include "aisle/commands/methods.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "exploration/exploration_trial.hpp"
#include "landmarks/landmark_trial.hpp"
#include "rooms/room_trial.hpp"
#include "sections/section_trial.hpp"

namespace aisle {
namespace {

struct TrialParams {
  LandmarkCourseParams landmarks;
  SectionTrialParams sections;
  RoomTrialParams route;

  void describe(FieldList& fields) {
    landmarks.describe(fields);
    fields.group("sections", sections);
    fields.group("route", route);
  }
};

}  // namespace

Outcome trial_parameters() {
  TrialParams params;
  return parameter_listing("trial", fields_of(params));
}

Result<Outcome> run_trial(const TrialOptions& options, Console& console) {
  if (options.method == "explore") return run_exploration_trial(options, console);
  const bool parks = options.method == "park", turns = options.method == "turnings";
  if (Problems problems = check_method(parks || turns ? "route" : options.method); !problems.empty())
    return problems;
  TrialParams all;
  FieldList fields = fields_of(all);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  LandmarkCourseParams& params = all.landmarks;
  if (options.speed_mps)
    params.navigator.speed.speed_mps = all.sections.navigator.speed.speed_mps =
        all.route.navigator.speed_mps = *options.speed_mps;
  if (options.method == "sections") return trial_by_sections(options, all.sections, console);
  if (turns) return trial_of_turnings(options, all.route, console);
  if (parks) return trial_of_parking(options, all.route, console);
  if (options.method == "route") return trial_by_route(options, all.route, console);
  return trial_by_landmarks(options, params, console);
}

}  // namespace aisle
