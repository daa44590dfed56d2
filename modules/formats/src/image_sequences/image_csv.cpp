#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/vehicle/arc.hpp"
#include "field_reader.hpp"
#include "image_sequences/image_folder.hpp"
#include "image_sequences/stamp_order.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

constexpr double kDriveMax_m = 1e6;
constexpr double kAngleMax_deg = 1e6;
constexpr double kSteeringMax_deg = 90;
constexpr double kSpeedMax_mps = 100;

using Cells = std::vector<std::string_view>;

Cells cells_of(std::string_view line) {
  Cells cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma), " \t\r\""));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// How a list tells the vehicle's motion.
enum class Motion { kNone, kPoses, kSteering, kSpeeds };

struct MotionColumns {
  Motion motion;
  std::vector<const char*> names;
};

const std::array<MotionColumns, 3>& motion_columns() {
  static const std::array<MotionColumns, 3> all = {{{Motion::kPoses, {"x_m", "y_m", "heading_deg"}},
                                                    {Motion::kSteering, {"distance_m", "steering_deg"}},
                                                    {Motion::kSpeeds, {"speed_mps", "yaw_rate_dps"}}}};
  return all;
}

/// The first line: which column is where.
class Header {
 public:
  explicit Header(std::string_view line) : names_(cells_of(line)) {}

  std::optional<std::size_t> find(std::string_view name) const {
    const auto at = std::find(names_.begin(), names_.end(), name);
    if (at == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(at - names_.begin());
  }

  bool has_all(const std::vector<const char*>& names) const {
    return std::all_of(names.begin(), names.end(), [&](const char* name) { return find(name); });
  }

  const Cells& names() const { return names_; }

 private:
  Cells names_;
};

Result<Motion> motion_told_by(const Header& header, const fs::path& file,
                              const ImageSequenceOptions& options) {
  Motion found = Motion::kNone;
  for (const auto& [motion, names] : motion_columns()) {
    const bool has_any =
        std::any_of(names.begin(), names.end(), [&](auto name) { return header.find(name); });
    if (!has_any) continue;
    const std::string needed = fmt::format("{}", fmt::join(names, ", "));
    if (!header.has_all(names)) return Problem{{file.string(), 1}, "has not all of the columns " + needed};
    if (found != Motion::kNone)
      return Problem{{file.string(), 1}, "gives the motion twice: leave out the columns " + needed};
    found = motion;
  }
  if (found == Motion::kSteering && !options.front_steered) {
    return Problem{{file.string(), 1, "steering_deg"},
                   "means nothing without the wheelbase: --vehicle names a front-steered vehicle"};
  }
  return found;
}

Problems check_columns(const Header& header, const fs::path& file, const ImageSequenceOptions& options) {
  Problems problems;
  if (!header.find("file")) {
    problems.push_back(
        {{file.string(), 1},
         "has no column 'file'; a list of images begins with 'stamp_s,file' and may go on with "
         "'x_m,y_m,heading_deg', 'distance_m,steering_deg' or 'speed_mps,yaw_rate_dps'"});
  }
  if (!header.find("stamp_s") && !options.rate_hz)
    problems.push_back(
        {{file.string(), 1}, "has no column 'stamp_s'; --image-rate HZ gives the images' rate"});
  return problems;
}

/// Columns of others are no mistake, but a misspelt one should be noticed.
void warn_of_other_columns(const Header& header, const fs::path& file, Problems& warnings) {
  Cells others;
  for (const std::string_view name : header.names()) {
    bool is_known = name == "stamp_s" || name == "file";
    for (const auto& [motion, names] : motion_columns())
      is_known |= std::find(names.begin(), names.end(), name) != names.end();
    if (!is_known) others.push_back(name);
  }
  if (others.empty()) return;
  std::vector<std::string> shown;
  for (const std::string_view name : others) shown.push_back(printable(name));
  warnings.push_back(
      {{file.string(), 1}, fmt::format("has columns that are not read: {}", fmt::join(shown, ", "))});
}

/// One row's cells by their names. Keeps the first failure, as FieldReader does.
class Row {
 public:
  Row(const Header& header, Cells cells) : header_(header), cells_(std::move(cells)) {
    if (cells_.size() != header.names().size())
      failure_ = fmt::format("has {} cells, the first line {}", cells_.size(), header.names().size());
  }

  std::string_view text(const char* column) const {
    const auto at = header_.find(column);
    return at && *at < cells_.size() ? cells_[*at] : std::string_view();
  }

  double number(const char* column, double min, double max) {
    const std::string_view cell = text(column);
    const auto value = parse_number(cell);
    if (value && *value >= min && *value <= max) return *value;
    fail(fmt::format("{}: '{}' is no number from {:g} to {:g}", column, printable(cell), min, max));
    return 0;
  }
  double number(const char* column, double limit) { return number(column, -limit, limit); }

  void fail(std::string what) {
    if (failure_.empty()) failure_ = std::move(what);
  }
  const std::string& failure() const { return failure_; }

 private:
  const Header& header_;
  Cells cells_;
  std::string failure_;
};

/// The vehicle's path, added up from row to row.
class DeadReckoning {
 public:
  DeadReckoning(Motion motion, std::optional<FrontSteered> vehicle) : motion_(motion), vehicle_(vehicle) {}

  /// Nothing is taken from a row that fails.
  std::optional<Pose2> at(Row& row, double stamp_s) {
    switch (motion_) {
      case Motion::kNone:
        return std::nullopt;
      case Motion::kPoses:
        return Pose2{row.number("x_m", kDriveMax_m), row.number("y_m", kDriveMax_m),
                     wrap_angle(row.number("heading_deg", kAngleMax_deg) * kDegree)};
      case Motion::kSteering:
        return by_steering(row);
      case Motion::kSpeeds:
        return by_speeds(row, stamp_s);
    }
    return std::nullopt;
  }

 private:
  Pose2 by_steering(Row& row) {
    const double distance_m = row.number("distance_m", kDriveMax_m);
    const double steering_rad = row.number("steering_deg", kSteeringMax_deg) * kDegree;
    if (!row.failure().empty()) return T_odom_vehicle_;
    const double step_m = distance_m - distance_m_.value_or(distance_m);
    distance_m_ = distance_m;
    return T_odom_vehicle_ = T_odom_vehicle_ * drive(*vehicle_, FrontSteeredMotion{step_m, steering_rad});
  }

  /// Between two rows, the mean of both rows' speeds.
  Pose2 by_speeds(Row& row, double stamp_s) {
    const Arc in_a_second = {row.number("speed_mps", kSpeedMax_mps),
                             row.number("yaw_rate_dps", kAngleMax_deg) * kDegree};
    if (!row.failure().empty()) return T_odom_vehicle_;
    if (before_) {
      const double half_s = std::max(0.0, stamp_s - before_->first) / 2;
      const Arc& was = before_->second;
      T_odom_vehicle_ = T_odom_vehicle_ * end_pose({(was.length_m + in_a_second.length_m) * half_s,
                                                    (was.turn_rad + in_a_second.turn_rad) * half_s});
    }
    before_ = {stamp_s, in_a_second};
    return T_odom_vehicle_;
  }

  Motion motion_;
  std::optional<FrontSteered> vehicle_;
  Pose2 T_odom_vehicle_;
  std::optional<double> distance_m_;
  std::optional<std::pair<double, Arc>> before_;
};

/// A row as an image; nullopt if the row fails.
std::optional<ListedImage> listed_image(Row& row, std::size_t index, const fs::path& folder,
                                        DeadReckoning& reckoning, const ImageSequenceOptions& options) {
  ListedImage image;
  image.stamp_s =
      options.rate_hz ? static_cast<double>(index) / *options.rate_hz : row.number("stamp_s", 0, kStampMax_s);
  const std::string_view name = row.text("file");
  if (name.empty() || name.find('\0') != std::string_view::npos) row.fail("names no file");
  image.file = folder / std::string(name);
  if (row.failure().empty()) image.T_odom_vehicle = reckoning.at(row, image.stamp_s);
  if (!row.failure().empty()) return std::nullopt;
  return image;
}

}  // namespace

Result<ImageList> parse_image_csv(std::string_view text, const fs::path& file,
                                  const ImageSequenceOptions& options) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const Header header(take_line(text));
  if (Problems problems = check_columns(header, file, options); !problems.empty()) return problems;
  const auto motion = motion_told_by(header, file, options);
  if (!motion) return motion.problems();
  ImageList list{.recording = file, .images = {}, .unreadable = {}, .warnings = {}};
  list.has_odometry = *motion != Motion::kNone;
  warn_of_other_columns(header, file, list.warnings);
  DeadReckoning reckoning(*motion, options.front_steered);
  std::size_t index = 0;
  for (long number = 2; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (trimmed(line).empty()) continue;
    Row row(header, cells_of(line));
    if (auto image = listed_image(row, index++, file.parent_path(), reckoning, options)) {
      list.images.push_back(std::move(*image));
    } else {
      list.unreadable.add({{file.string(), number}, row.failure()});
    }
  }
  return list;
}

}  // namespace aisle
