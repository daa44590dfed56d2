#include "aisle/formats/logs/trajectory.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "aisle/formats/whole_file.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

/// The yaw of a rotation given as the unit quaternion x, y, z, w.
double read_yaw(FieldReader& fields) {
  const double x = fields.number("qx", 1.01);
  const double y = fields.number("qy", 1.01);
  const double z = fields.number("qz", 1.01);
  const double w = fields.number("qw", 1.01);
  const double norm = std::sqrt(x * x + y * y + z * z + w * w);
  if (fields.ok() && std::abs(norm - 1) > 0.01)
    fields.fail(fmt::format("the quaternion's length is {:g}, not 1", norm));
  return std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

}  // namespace

std::string tum_text(std::span<const double> stamps_s, std::span<const Pose2> T_map_vehicle) {
  if (stamps_s.size() != T_map_vehicle.size()) {
    throw std::invalid_argument(
        fmt::format("tum_text: {} stamps, {} poses", stamps_s.size(), T_map_vehicle.size()));
  }
  std::string text = "# stamp x y z qx qy qz qw\n";
  for (std::size_t i = 0; i < stamps_s.size(); ++i) {
    const Pose2& pose = T_map_vehicle[i];
    fmt::format_to(std::back_inserter(text), "{:.6f} {:.6f} {:.6f} 0 0 0 {:.9f} {:.9f}\n", stamps_s[i],
                   pose.x, pose.y, std::sin(pose.theta / 2), std::cos(pose.theta / 2));
  }
  return text;
}

Result<Trajectory> parse_tum(std::string_view text, const std::string& name) {
  Trajectory trajectory;
  ProblemList problems(name);
  for (long line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    const std::string_view first = FieldReader(line).word();
    if (first.empty() || first.front() == '#') continue;
    FieldReader fields(line);
    trajectory.stamps_s.push_back(fields.number("stamp", kAnyNumber));
    Pose2& pose = trajectory.T_map_vehicle.emplace_back();
    pose.x = fields.number("x", kAnyNumber);
    pose.y = fields.number("y", kAnyNumber);
    fields.number("z", kAnyNumber);
    pose.theta = read_yaw(fields);
    fields.remaining(0);
    if (!fields.ok()) problems.add(line_number, fields.failure());
  }
  if (!problems.empty()) return problems.take();
  return trajectory;
}

Result<Trajectory> read_tum(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path);
  if (!text) return text.problems();
  return parse_tum(*text, path.string());
}

}  // namespace aisle
