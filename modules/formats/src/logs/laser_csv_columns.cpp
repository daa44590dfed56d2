#include "logs/laser_csv_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "aisle/core/angle.hpp"
#include "field_reader.hpp"

namespace aisle {
namespace {

constexpr std::size_t kRangeColumnsMax = 10000;
constexpr double kFactMax_m = 1e5;

enum class CsvDimension { kTime, kLength, kAngle };

struct CsvUnit {
  std::string_view ending;
  CsvDimension dimension;
  double scale;
};

constexpr std::array<CsvUnit, 9> kCsvUnits = {{{"_s", CsvDimension::kTime, 1},
                                               {"_ms", CsvDimension::kTime, 1e-3},
                                               {"_us", CsvDimension::kTime, 1e-6},
                                               {"_ns", CsvDimension::kTime, 1e-9},
                                               {"_m", CsvDimension::kLength, 1},
                                               {"_cm", CsvDimension::kLength, 1e-2},
                                               {"_mm", CsvDimension::kLength, 1e-3},
                                               {"_rad", CsvDimension::kAngle, 1},
                                               {"_deg", CsvDimension::kAngle, kDegree}}};

struct CsvQuantity {
  std::string_view name;
  CsvDimension dimension;
};

/// A name such as "heading_deg" as quantity and unit; no unit of this dimension: none.
std::optional<CsvColumn> column_of(std::string_view name, const CsvQuantity& quantity) {
  if (!name.starts_with(quantity.name)) return std::nullopt;
  const std::string_view ending = name.substr(quantity.name.size());
  for (const CsvUnit& unit : kCsvUnits) {
    if (ending == unit.ending && unit.dimension == quantity.dimension) return CsvColumn{0, unit.scale};
  }
  return std::nullopt;
}

/// The number of a name such as "range_17_mm".
std::optional<std::size_t> reading_number(std::string_view name) {
  constexpr std::string_view kBeginning = "range_";
  if (!name.starts_with(kBeginning)) return std::nullopt;
  name.remove_prefix(kBeginning.size());
  const std::string_view digits = name.substr(0, name.find('_'));
  const auto number = parse_number(digits);
  if (!number || !(*number >= 0 && *number < static_cast<double>(kRangeColumnsMax)) ||
      *number != std::floor(*number)) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(*number);
}

constexpr std::string_view kAroundCell = " \t\r\"'";

char separator_of(std::string_view header) {
  for (const char separator : {',', ';', '\t'}) {
    if (header.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

/// Sorts the columns of a header into what they mean.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view header) {
    columns_.separator = separator_of(header);
    std::vector<std::string_view> cells;
    split_csv_line(header, columns_.separator, cells);
    columns_.names.assign(cells.begin(), cells.end());
  }

  /// What is wrong; empty: nothing.
  std::string read(CsvRows rows) {
    for (std::size_t index = 0; index < columns_.names.size(); ++index) {
      const std::string& name = columns_.names[index];
      if (!take(name, index) && !name.empty()) columns_.unknown.push_back(name);
      if (!twice_.empty()) return fmt::format("has '{}' twice", twice_);
    }
    if (rows == CsvRows::kPoses && time_ && !columns_.x)
      return "has no columns x_m, y_m (or _cm, _mm), heading_rad (or _deg)";
    return what_is_missing(rows);
  }

  CsvColumns columns() && { return std::move(columns_); }

 private:
  bool take(std::string_view name, std::size_t index) {
    if (auto column = column_of(name, {"time", CsvDimension::kTime})) return put(time_, *column, name, index);
    if (auto column = column_of(name, {"x", CsvDimension::kLength}))
      return put(columns_.x, *column, name, index);
    if (auto column = column_of(name, {"y", CsvDimension::kLength}))
      return put(columns_.y, *column, name, index);
    if (auto column = column_of(name, {"heading", CsvDimension::kAngle})) {
      return put(columns_.heading, *column, name, index);
    }
    if (auto column = column_of(name, {"first_angle", CsvDimension::kAngle})) {
      return put(columns_.first_angle, *column, name, index);
    }
    if (auto column = column_of(name, {"angle_step", CsvDimension::kAngle})) {
      return put(columns_.angle_step, *column, name, index);
    }
    const auto number = reading_number(name);
    if (!number) return false;
    const std::string quantity = fmt::format("range_{}", *number);
    const auto column = column_of(name, {quantity, CsvDimension::kLength});
    if (!column) return false;
    if (!readings_.emplace(*number, CsvColumn{index, column->scale}).second) twice_ = name;
    return true;
  }

  bool put(std::optional<CsvColumn>& to, CsvColumn column, std::string_view name, std::size_t index) {
    if (to) twice_ = name;
    to = CsvColumn{index, column.scale};
    return true;
  }

  std::string what_is_missing(CsvRows rows) {
    if (!time_) return "has no column 'time_s' (or _ms, _us, _ns)";
    columns_.time = *time_;
    if (columns_.x.has_value() != columns_.y.has_value() ||
        columns_.x.has_value() != columns_.heading.has_value()) {
      return "has only some of the columns x_m, y_m, heading_rad (or _deg); odometry needs all three";
    }
    if (columns_.first_angle.has_value() != columns_.angle_step.has_value()) {
      return "has only one of the columns first_angle_deg and angle_step_deg";
    }
    if (rows == CsvRows::kScans && readings_.size() < 2)
      return "has no columns 'range_0_m', 'range_1_m' ... (or _cm, _mm)";
    for (const auto& [number, column] : readings_) {
      if (number != columns_.ranges.size())
        return fmt::format("has no column 'range_{}_m'", columns_.ranges.size());
      columns_.ranges.push_back(column);
    }
    return "";
  }

  CsvColumns columns_;
  std::optional<CsvColumn> time_;
  std::map<std::size_t, CsvColumn> readings_;
  std::string twice_;
};

}  // namespace

void split_csv_line(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  while (true) {
    const std::size_t end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end), kAroundCell));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
  }
}

Result<CsvColumns> read_csv_header(std::string_view header, const std::string& name, long line,
                                   CsvRows rows) {
  HeaderReader reader(header);
  const std::string problem = reader.read(rows);
  if (!problem.empty()) return Problem{{name, line}, "the header " + problem};
  return std::move(reader).columns();
}

std::optional<CsvFact> read_csv_fact(std::string_view comment) {
  constexpr std::array<CsvQuantity, 6> kFacts = {{{"first_angle", CsvDimension::kAngle},
                                                  {"angle_step", CsvDimension::kAngle},
                                                  {"range_max", CsvDimension::kLength},
                                                  {"mount_x", CsvDimension::kLength},
                                                  {"mount_y", CsvDimension::kLength},
                                                  {"mount_heading", CsvDimension::kAngle}}};
  const std::size_t colon = comment.find_first_of(":=");
  if (colon == std::string_view::npos) return std::nullopt;
  const std::string_view name = trimmed(comment.substr(0, colon), kAroundCell);
  const std::string_view text = trimmed(comment.substr(colon + 1), kAroundCell);
  for (const CsvQuantity& quantity : kFacts) {
    if (!name.starts_with(quantity.name) || name.find(' ') != std::string_view::npos) continue;
    const auto column = column_of(name, quantity);
    if (!column)
      return CsvFact{quantity.name, 0, fmt::format("'{}' has no unit that is known here", printable(name))};
    const double limit = quantity.dimension == CsvDimension::kAngle ? 2.1 * kPi : kFactMax_m;
    const double value = parse_number(text).value_or(std::nan("")) * column->scale;
    if (std::abs(value) <= limit) return CsvFact{quantity.name, value};
    return CsvFact{quantity.name, 0, fmt::format("'{}' is no usable number for {}", printable(text), name)};
  }
  return std::nullopt;
}

bool begins_laser_csv(std::string_view head) {
  while (!head.empty()) {
    const std::string_view line = take_line(head);
    if (trimmed(line, kAroundCell).empty() || trimmed(line, kAroundCell).front() == '#') continue;
    return line.find("time_") != std::string_view::npos && line.find("range_") != std::string_view::npos;
  }
  return false;
}

}  // namespace aisle
