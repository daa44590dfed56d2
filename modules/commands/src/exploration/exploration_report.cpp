#include "exploration/exploration_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "aisle/report/building_picture.hpp"
#include "aisle/report/exploration_charts.hpp"
#include "aisle/report/report_page.hpp"

namespace aisle {
namespace {

/// A figure's name for people; its key ends with the unit.
struct FigureName {
  std::string words;  ///< "home error"
  std::string unit;   ///< "m"; empty: none
};

FigureName name_of_figure(std::string key) {
  FigureName name;
  for (const std::string_view unit : {"m", "m2", "s", "ms", "deg", "share"}) {
    if (!key.ends_with("_" + std::string(unit))) continue;
    name.unit = unit;
    key.resize(key.size() - unit.size() - 1);
    break;
  }
  std::replace(key.begin(), key.end(), '_', ' ');
  name.words = std::move(key);
  return name;
}

std::string with_unit(double value, const std::string& unit) {
  if (unit == "share") return fmt::format("{:.1f} %", 100 * value);
  if (unit == "m" && std::abs(value) < 1) return fmt::format("{:.1f} cm", 100 * value);
  if (unit == "m2") return fmt::format("{:.1f} m²", value);
  return fmt::format("{:.1f} {}", value, unit);
}

std::string value_for_people(const nlohmann::ordered_json& value, const std::string& unit) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return unit.empty() || !value.is_number() ? value.dump() : with_unit(value.get<double>(), unit);
}

/// Flattens nested figures: "cycle median" of {"cycle_ms": {"median": ...}}.
void add_figures(const nlohmann::ordered_json& figures, std::vector<ReportFigure>& list) {
  for (const auto& [key, value] : figures.items()) {
    const FigureName name = name_of_figure(key);
    if (!value.is_object()) {
      list.push_back({name.words, value_for_people(value, name.unit)});
      continue;
    }
    for (const auto& [part, part_value] : value.items())
      list.push_back({name.words + " " + part, value_for_people(part_value, name.unit)});
  }
}

std::vector<std::string> warnings_of(const ExplorationRecord& record, const nlohmann::ordered_json& figures) {
  std::vector<std::string> warnings;
  if (!record.certified()) warnings.push_back("no certificate: " + record.ended_because);
  if (!record.came_home) warnings.emplace_back("the vehicle did not come home");
  if (record.paths_waiting > 0)
    warnings.push_back(fmt::format("{} paths are still to be explored", record.paths_waiting));
  if (record.paths_abandoned > 0)
    warnings.push_back(fmt::format("{} paths were given up", record.paths_abandoned));
  if (const auto touched = figures.value("collisions", std::size_t{0}); touched > 0)
    warnings.push_back(fmt::format("{} collisions", touched));
  return warnings;
}

}  // namespace

std::string exploration_report(const ExplorationPicture& picture, const Building& building,
                               const Outcome& outcome) {
  const ExplorationRecord& record = picture.record;
  ReportPage page{.title = "Exploring " + building.name, .summary = picture.caption};
  page.warnings = warnings_of(record, outcome.figures);
  add_figures(outcome.figures, page.figures);
  page.pictures = {{"Map and path", svg(picture), "Free floor is white, unseen floor is grey."},
                   {"Graph of corridors", svg(BuildingPicture{.building = building}),
                    "Crossings, ends and paths as learned."},
                   {"Known floor over the distance travelled", coverage_svg(record), ""},
                   {"States and stack", transducer_svg(record),
                    "States of the transducer, and number of paths that wait."}};
  return html(page);
}

}  // namespace aisle
