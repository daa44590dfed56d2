#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"

namespace aisle {

/// A column of the table, with what its values are multiplied by to be metres, radians or seconds.
struct CsvColumn {
  std::size_t index = 0;
  double scale = 1;
};

/// Where a table has what; the header says it.
struct CsvColumns {
  char separator = ',';
  std::vector<std::string> names;  ///< of all columns
  CsvColumn time;
  std::optional<CsvColumn> x, y, heading, first_angle, angle_step;
  std::vector<CsvColumn> ranges;          ///< by their numbers
  std::vector<std::string> unknown = {};  ///< columns that mean nothing here
};

/// What a table must have beside the time: readings, or poses.
enum class CsvRows { kScans, kPoses };

/// @param line  number of the header line
Result<CsvColumns> read_csv_header(std::string_view header, const std::string& name, long line,
                                   CsvRows rows = CsvRows::kScans);

/// A fact of the scanner from a comment, such as "# first_angle_deg: -90".
struct CsvFact {
  std::string_view quantity;  ///< its name without the unit
  double value = 0;           ///< metres or radians
  std::string problem = {};   ///< what is wrong with it; empty: nothing
};

/// None if the comment does not begin with the name of a fact.
std::optional<CsvFact> read_csv_fact(std::string_view comment);

/// The cells of a line, without quotation marks and blanks about them.
void split_csv_line(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Whether a text with these first bytes is such a table: its header names a time and readings.
bool begins_laser_csv(std::string_view head);

}  // namespace aisle
