#include "aisle/trials/trial.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "aisle/commands/method.hpp"
#include "aisle/commands/method_params.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "exploration/exploration_trial.hpp"
#include "landmarks/landmark_trial.hpp"
#include "localisation/localisation_trial.hpp"
#include "recorded_trial.hpp"
#include "rooms/room_trial.hpp"
#include "sections/section_trial.hpp"

namespace aisle {
namespace {

using TrialParams = MethodParams<LandmarkCourseParams, SectionTrialParams, RoomTrialParams>;

Result<TrialParams> read_params(const TrialOptions& options) {
  TrialParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (options.speed_mps)
    params.landmarks.navigator.speed.speed_mps = params.sections.navigator.speed.speed_mps =
        params.rooms.navigator.speed_mps = *options.speed_mps;
  return params;
}

/// A trial with its part of the parameters.
template <auto trial, auto part>
Result<TrialResult> with_params(const TrialOptions& options, Console& console) {
  const auto params = read_params(options);
  if (!params) return params.problems();
  return trial(options, (*params).*part, console);
}

/// What `aisle trial` can try.
struct TrialMethod {
  std::string_view name;
  Result<TrialResult> (*run)(const TrialOptions& options, Console& console);
};

constexpr TrialMethod kTrialMethods[] = {
    {"landmarks", with_params<trial_by_landmarks, &TrialParams::landmarks>},
    {"sections", with_params<trial_by_sections, &TrialParams::sections>},
    {"rooms", with_params<trial_by_route, &TrialParams::rooms>},
    {"turnings", with_params<trial_of_turnings, &TrialParams::rooms>},
    {"park", with_params<trial_of_parking, &TrialParams::rooms>},
    {"explore", run_exploration_trial},
    {"localise", run_localisation_trial}};

}  // namespace

std::vector<std::string_view> trial_methods() {
  std::vector<std::string_view> names;
  for (const TrialMethod& trial : kTrialMethods) names.push_back(trial.name);
  return names;
}

Outcome trial_parameters() {
  TrialParams params;
  return parameter_listing("trial", fields_of(params));
}

Result<TrialResult> run_recorded_trial(const TrialOptions& options, Console& console) {
  const std::string method = present_method(options.method, console);
  for (const TrialMethod& trial : kTrialMethods) {
    if (trial.name != method) continue;
    auto result = trial.run(options, console);
    if (result) result->records.report(options, result->outcome);
    return result;
  }
  return Problem{{"METHOD"},
                 fmt::format("'{}' is none of {}", options.method, fmt::join(trial_methods(), ", "))};
}

Result<Outcome> run_trial(const TrialOptions& options, Console& console) {
  auto result = run_recorded_trial(options, console);
  if (!result) return result.problems();
  if (!options.process.is_first()) return Outcome{.verb = "trial", .is_printed_elsewhere = true};
  return std::move(result->outcome);
}

}  // namespace aisle
