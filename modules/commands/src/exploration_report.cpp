#include "exploration_report.hpp"

#include <fmt/format.h>

#include <vector>

#include "aisle/report/corridor_picture.hpp"
#include "aisle/report/exploration_charts.hpp"
#include "aisle/report/report_page.hpp"

namespace aisle {
namespace {

/// "home_error_m" -> "home error m"; figures within figures one by one.
void add_figures(const nlohmann::ordered_json& figures, const std::string& before,
                 std::vector<ReportFigure>& list) {
  for (const auto& [key, value] : figures.items()) {
    std::string name = before + key;
    for (char& c : name) c = c == '_' ? ' ' : c;
    if (value.is_object()) {
      add_figures(value, name + " ", list);
    } else {
      list.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
    }
  }
}

std::vector<std::string> warnings_of(const ExplorationRecord& record, const nlohmann::ordered_json& figures) {
  std::vector<std::string> warnings;
  if (!record.certified()) warnings.push_back("no certificate: " + record.ended_because);
  if (!record.came_home) warnings.emplace_back("the vehicle did not come home");
  if (record.paths_waiting > 0) warnings.push_back(fmt::format("{} paths wait", record.paths_waiting));
  if (record.paths_abandoned > 0)
    warnings.push_back(fmt::format("{} paths were left undone", record.paths_abandoned));
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
  add_figures(outcome.figures, "", page.figures);
  page.pictures = {
      {"Map and way", svg(picture), "Free floor white, what nobody has seen grey."},
      {"Graph of corridors", svg(CorridorPicture{.building = building}),
       "Crossings, ends and ways as learned."},
      {"Floor known over the way", coverage_svg(record), ""},
      {"States and stack", transducer_svg(record), "What the transducer did, and how many paths waited."}};
  return html(page);
}

}  // namespace aisle
