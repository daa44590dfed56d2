#include "aisle/formats/images/bee_map.hpp"

#include <fmt/format.h>

#include <optional>

#include "field_reader.hpp"
#include "file_limits.hpp"

namespace aisle {
namespace {

constexpr std::string_view kSpecification = "robot_specifications->";
constexpr std::string_view kCells = "global_map[0]:";
constexpr std::size_t kBeeCellsMax = 33'000'000;
constexpr double kResolutionMin_cm = 0.1, kResolutionMax_cm = 1000;
constexpr double kFreeFrom = 0.8;  ///< about map_server's thresholds, of a probability of being free
constexpr double kOccupiedTo = 0.35;

class BeeMapReader {
 public:
  BeeMapReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<PlanReading> read() {
    if (auto problem = read_head()) return *problem;
    if (auto problem = read_cells()) return *problem;
    return std::move(reading_);
  }

 private:
  Problem problem(std::string what) const { return {{name_, line_}, std::move(what)}; }

  /// Up to the line that says how many cells follow.
  std::optional<Problem> read_head() {
    std::optional<double> resolution_cm;
    while (!text_.empty()) {
      ++line_;
      const std::string_view line = take_line(text_);
      FieldReader fields(line);
      const std::string_view word = fields.word();
      if (word == kCells) return read_size(fields, resolution_cm);
      if (!word.starts_with(kSpecification)) continue;
      const std::string_view key = word.substr(kSpecification.size());
      const double value = fields.any_number(std::string(key).c_str());
      if (!fields.ok()) return problem(fields.failure());
      if (key == "resolution") resolution_cm = value;
      if (key.starts_with("autoshifted") && value != 0)
        reading_.warnings.push_back(
            problem(fmt::format("{} is {:g}: the map is not shifted back", key, value)));
    }
    return problem(fmt::format("ends without '{}' and the number of cells", kCells));
  }

  std::optional<Problem> read_size(FieldReader& fields, const std::optional<double>& resolution_cm) {
    const std::size_t columns = fields.count("columns", 1, kPlanSideMax);
    const std::size_t rows = fields.count("rows", 1, kPlanSideMax);
    if (!fields.ok()) return problem(fields.failure());
    if (columns * rows > kBeeCellsMax)
      return problem(fmt::format("has {} x {} cells; at most {} are read", columns, rows, kBeeCellsMax));
    if (!resolution_cm || !(*resolution_cm >= kResolutionMin_cm && *resolution_cm <= kResolutionMax_cm))
      return problem(fmt::format("needs '{}resolution' above, from {:g} to {:g} cm", kSpecification,
                                 kResolutionMin_cm, kResolutionMax_cm));
    reading_.plan = FloorPlan(static_cast<int>(columns), static_cast<int>(rows), 1);
    reading_.plan.cell_m = *resolution_cm / 100;
    reading_.unseen.assign(reading_.plan.solid.size(), 1);
    return std::nullopt;
  }

  /// Column by column, each from y = 0 on.
  std::optional<Problem> read_cells() {
    FloorPlan& plan = reading_.plan;
    const std::size_t count = plan.solid.size();
    std::size_t k = 0;
    while (!text_.empty()) {
      ++line_;
      FieldReader fields(take_line(text_));
      for (std::string_view word = fields.word(); !word.empty(); word = fields.word(), ++k) {
        const auto free = parse_number(word);
        if (!free || !(*free <= 1)) return problem(fmt::format("'{}' is not a probability", printable(word)));
        if (k >= count) return problem(fmt::format("has more than {} x {} cells", plan.width, plan.height));
        const auto rows = static_cast<std::size_t>(plan.height);
        const std::size_t cell = plan.index(static_cast<int>(k / rows), static_cast<int>(k % rows));
        plan.solid[cell] = *free > kFreeFrom ? 0 : 1;
        reading_.unseen[cell] = *free >= 0 && (*free > kFreeFrom || *free < kOccupiedTo) ? 0 : 1;
      }
    }
    if (k == count) return std::nullopt;
    return problem(fmt::format("ends after {} of {} cells; it seems to be cut off", k, count));
  }

  std::string_view text_;
  std::string name_;
  long line_ = 0;
  PlanReading reading_ = {FloorPlan(), {}};
};

}  // namespace

Result<PlanReading> parse_bee_map(std::string_view text, const std::string& name) {
  return BeeMapReader(text, name).read();
}

bool begins_bee_map(std::string_view head) {
  return head.starts_with(kSpecification);
}

}  // namespace aisle
