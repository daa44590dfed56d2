#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/method.hpp"
#include "aisle/core/edit_distance.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/section_text.hpp"
#include "aisle/geometry/polyline.hpp"
#include "aisle/missions/sections/section_driver.hpp"
#include "aisle/missions/statistics.hpp"
#include "landmarks/landmark_course.hpp"
#include "mission_runs.hpp"
#include "not_taught.hpp"
#include "sections/section_course.hpp"
#include "sections/section_trial.hpp"
#include "trial_setting.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

/// Without halls: they have no wall-floor edge to follow.
constexpr BuildingKind kCorridorBuildings[] = {BuildingKind::kOffice, BuildingKind::kRing,
                                               BuildingKind::kComb};
constexpr double kBend_rad = 20 * kDegree;  // change of direction from which on a tour's corner is a turn
constexpr double kTurnBack_rad = 135 * kDegree;
constexpr double kLongest_m = 60, kSamePoint_m = 0.1, kEndMin_m = 1.5;

/// A person does not begin or end a route right beside a corner.
std::vector<Vec2> without_short_ends(std::vector<Vec2> path) {
  while (path.size() > 2 && (path[1] - path[0]).norm() < kEndMin_m) path.erase(path.begin());
  while (path.size() > 2 && (path[path.size() - 1] - path[path.size() - 2]).norm() < kEndMin_m)
    path.pop_back();
  return path;
}

/// The longest part of a tour that does not turn back, cut to the greatest length of a mission.
std::vector<Vec2> longest_without_turning_back(const std::vector<Vec2>& tour) {
  std::vector<Vec2> longest, path;
  for (const Vec2& p : tour) {
    if (path.size() >= 2) {
      const Vec2 before = path.back() - path[path.size() - 2];
      const bool turns_back =
          std::abs(wrap_angle(heading_of(p - path.back()) - heading_of(before))) > kTurnBack_rad;
      const bool is_long = polyline_length_m(path) + (p - path.back()).norm() > kLongest_m;
      if (turns_back || is_long) path = {path.back()};
    }
    if (path.empty() || (p - path.back()).norm() > kSamePoint_m) path.push_back(p);
    if (polyline_length_m(path) > polyline_length_m(longest)) longest = path;
  }
  return without_short_ends(std::move(longest));
}

/// The sections that a path should be split into, by its shape in the building: one letter per section.
std::string due_letters(const std::vector<Vec2>& path, const SectionLearningParams& params) {
  std::string letters = "a";
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double turn_rad = wrap_angle(heading_of(path[i + 1] - path[i]) - heading_of(path[i] - path[i - 1]));
    if (std::abs(turn_rad) < kBend_rad) continue;
    if (turn_rad < 0) {
      letters.back() = 'h';
      letters += "ra";
    } else {
      letters += std::abs(turn_rad - kPi / 2) < params.corner_rad ? "ca" : "la";
    }
  }
  return letters;
}

/// One letter per section. Sections in one line, which end where the wall-floor edge steps to the side, count
/// as one.
std::string letters_of(const SectionList& sections) {
  std::string letters;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const auto is_ahead = [&](std::size_t at) {
      return at < sections.size() &&
             (sections[at].kind == Section::Kind::kFollow || sections[at].kind == Section::Kind::kHybrid);
    };
    if (!is_ahead(i) || !is_ahead(i + 1)) letters += section_text(sections[i]).front();
  }
  return letters;
}

Result<SimulationSetting> section_setting(const TrialOptions& options, std::uint64_t seed) {
  auto setting =
      setting_of_seed(options, seed, kSectionMethod.vehicle_or_usual(options.vehicle), kCorridorBuildings);
  if (!setting) return setting.problems();
  if (Problems problems = unfit_for_sections(setting->vehicle.description); !problems.empty())
    return at_file(problems, options.vehicle);
  setting->world.tour = longest_without_turning_back(setting->world.tour);
  setting->world.start.reset();
  if (Problems problems = keep_corridor_camera(*setting); !problems.empty())
    return at_file(problems, options.vehicle);
  return setting;
}

/// What the statistics need of a mission: exact, unlike its figures.
Json counted_of(const JudgedSectionMission& judged, const std::string& due, const std::string& learned) {
  const SectionMissionResult& mission = judged.mission;
  const SectionErrors& errors = *judged.errors;
  Json counted = {{"arrived", mission.end.arrived},
                  {"collisions", mission.truth->collisions},
                  {"letters", std::max(due.size(), learned.size())},
                  {"letters_wrong", edit_distance(due, learned)},
                  {"closing_m", errors.closing_m},
                  {"closing_deg", to_degrees(errors.closing_rad)},
                  {"cycle_s", mission.cycle_s}};
  if (errors.wall_distance_m.count() > 0) counted["wall_m"] = errors.wall_distance_m.rms();
  return counted;
}

/// One seed: teach, learn, drive there and back. Its record holds the drive, or why the route was not taught.
Result<Json> section_record(const TrialOptions& options, const SectionTrialParams& params, std::uint64_t seed,
                            Progress& progress) {
  const auto setting = section_setting(options, seed);
  if (!setting) return setting.problems();
  const auto course = teach_sections(*setting, params.learner, seed, options.teachings, progress);
  if (!course) return not_taught_record(seed, to_string(course.problems()));
  const SectionList& sections = course->learned.building.routes.front().sections;
  const std::string due = due_letters(setting->world.tour, params.learner.learning);
  const std::string learned = letters_of(sections);
  const auto result =
      drive_there_and_back(*setting, params.navigator, *course, 1000 * (seed + 1), false, progress);
  if (!result) return result.problems();
  const SectionMissionResult& mission = result->mission;
  Json run = {{"seed", seed},
              {"world", setting->world.name.empty() ? setting->world_file.string() : setting->world.name},
              {"sections", learned},
              {"sections_due", due}};
  for (const Section& section : sections) run["list"].push_back(section_text(section));
  run.update(figures_of(*result));
  return Json{{"ok", mission.end.arrived && mission.truth->collisions == 0},
              {"run", run},
              {"counted", counted_of(*result, due, learned)}};
}

struct SectionTrial {
  std::size_t missions = 0, arrived = 0, collisions = 0;
  std::size_t letters = 0, letters_wrong = 0;
  Spread closing_m, closing_deg, wall_m;
  std::vector<double> cycle_s;
  Json runs = Json::array();
  NotTaught not_taught;

  double accuracy() const {
    return letters == 0 ? 0 : 1 - static_cast<double>(letters_wrong) / static_cast<double>(letters);
  }

  void add(const Json& record) {
    if (not_taught.add(record)) return;
    const Json& counted = record.at("counted");
    const bool has_arrived = counted.at("arrived");
    ++missions;
    arrived += has_arrived ? 1U : 0U;
    collisions += counted.at("collisions").get<std::size_t>();
    letters += counted.at("letters").get<std::size_t>();
    letters_wrong += counted.at("letters_wrong").get<std::size_t>();
    if (has_arrived) {
      closing_m.add(counted.at("closing_m"));
      closing_deg.add(counted.at("closing_deg"));
    }
    if (counted.contains("wall_m")) wall_m.add(counted["wall_m"]);
    for (const Json& one_s : counted.at("cycle_s")) cycle_s.push_back(one_s);
    runs.push_back(record.at("run"));
  }
};

Outcome section_outcome(const SectionTrial& trial) {
  Outcome outcome{.verb = "trial",
                  .ok = trial.missions > 0 && trial.arrived == trial.missions && trial.collisions == 0};
  const double share =
      static_cast<double>(trial.arrived) / static_cast<double>(std::max<std::size_t>(trial.missions, 1));
  outcome.figures = {{"missions", trial.missions},
                     {"arrived_share", rounded(share, 4)},
                     {"collisions", trial.collisions},
                     {"section_accuracy", rounded(trial.accuracy(), 4)},
                     {"closing_error_m", trial.closing_m.json(4)},
                     {"closing_error_deg", trial.closing_deg.json(3)},
                     {"wall_distance_rmse_m", rounded(trial.wall_m.mean(), 4)},
                     {"cycle_ms", cycle_figures(trial.cycle_s)},
                     {"simulated", true},
                     {"method", "sections"},
                     {"not_taught", trial.not_taught.json()},
                     {"runs", trial.runs}};
  outcome.text = fmt::format(
      "simulated: {} missions there and back, {:.1f} % arrived, {} collisions\n"
      "sections right: {:.1f} %; home within {:.1f} cm, {:.2f} deg (mean), {:.1f} cm, {:.2f} deg (worst)\n"
      "kept its distance from the right base line within {:.1f} cm (rms)\n",
      trial.missions, 100 * share, trial.collisions, 100 * trial.accuracy(), 100 * trial.closing_m.mean(),
      trial.closing_deg.mean(), 100 * trial.closing_m.worst(), trial.closing_deg.worst(),
      100 * trial.wall_m.mean());
  outcome.text += trial.not_taught.text();
  return outcome;
}

}  // namespace

Result<TrialResult> trial_by_sections(const TrialOptions& options, const SectionTrialParams& params,
                                      Console& console) {
  auto ran = run_missions(options,
                          per_seed(options,
                                   [&](std::uint64_t seed, Console& quiet) {
                                     return section_record(options, params, seed, quiet.progress);
                                   }),
                          console);
  if (!ran) return ran.problems();
  SectionTrial trial;
  for (const auto& [mission, record] : ran->records) trial.add(record);
  Outcome outcome = section_outcome(trial);
  return TrialResult{std::move(outcome), std::move(*ran)};
}

}  // namespace aisle
