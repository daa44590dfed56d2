#include "scan_fitting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/formats/sessions/ros_time.hpp"

namespace aisle {
namespace {

constexpr double kSameBeam = 0.02;  // of a step between beams: no beam is nearer to another's place

/// Two neighbouring readings are of one surface if it is not seen more flatly than this.
constexpr double kFlattest = 12;  // times the distance between neighbours on a surface across the beam

/// A reading that saw something, in the scanner's frame at the end of the scan.
struct SeenPoint {
  Vec2 p_laser = Vec2::Zero();
  double angle_rad = 0;  ///< of its beam, which the vehicle's motion has turned
};

double reading_s(const BagScan& scan, std::size_t reading) {
  const double period_s = scan.beams.period_s;
  const std::size_t before = period_s >= 0 ? reading : scan.ranges_m.size() - 1 - reading;
  return ros::stamp_s(scan.time.stamp) + std::abs(period_s) * static_cast<double>(before);
}

bool has_the_beams_of(const BagScan& scan, const BeamGrid& grid) {
  const double most_rad = kSameBeam * grid.scanner.angle_step_rad;
  const double count = static_cast<double>(grid.beams);
  return scan.ranges_m.size() == grid.beams &&
         std::abs(wrap_angle(scan.beams.first_angle_rad - grid.scanner.first_angle_rad)) < most_rad &&
         std::abs(scan.beams.angle_step_rad - grid.scanner.angle_step_rad) * count < most_rad;
}

bool has_moved(const Pose2& T) {
  return T.position().norm() > 1e-4 || std::abs(T.theta) > 1e-4;
}

/// Fills the beams of one scan.
class Fitting {
 public:
  explicit Fitting(const BeamGrid& grid) : grid_(grid), ranges_m_(grid.beams, kUnset) {}

  /// The beams between two neighbouring readings.
  void add_surface(const SeenPoint& from, const SeenPoint& to) {
    const double a_m = from.p_laser.norm(), b_m = to.p_laser.norm();
    const double apart_rad = std::abs(wrap_angle(to.angle_rad - from.angle_rad));
    if (std::abs(b_m - a_m) > kFlattest * apart_rad * std::min(a_m, b_m)) return;
    const double first = place_of(from.angle_rad);
    const double last = first + wrap_angle(to.angle_rad - from.angle_rad) / grid_.scanner.angle_step_rad;
    const Vec2 along = to.p_laser - from.p_laser;
    const auto end = static_cast<long>(std::floor(last));
    for (auto place = static_cast<long>(std::ceil(first)); place <= end; ++place) {
      const double beams = static_cast<double>(place);
      const Vec2 beam = unit(grid_.scanner.first_angle_rad + grid_.scanner.angle_step_rad * beams);
      const double across = cross(beam, along);
      if (std::abs(across) > 1e-9) set(wrapped(beams), cross(from.p_laser, along) / across);
    }
  }

  /// To the nearest beam, if nothing is known of it.
  void add_reading(double angle_rad, double range_m) {
    const double place = std::round(place_of(angle_rad));
    if (is_beam(place) && ranges_m_[static_cast<std::size_t>(place)] == kUnset) set(place, range_m);
  }

  std::vector<float> take_ranges() {
    std::replace(ranges_m_.begin(), ranges_m_.end(), kUnset, 0.0F);
    return std::move(ranges_m_);
  }

 private:
  static constexpr float kUnset = -1;

  /// Which beam this is, between two of them.
  double place_of(double angle_rad) const {
    const double turn_rad = angle_rad - grid_.scanner.first_angle_rad;
    const double positive_rad = turn_rad - 2 * kPi * std::floor(turn_rad / (2 * kPi));
    return wrapped(positive_rad / grid_.scanner.angle_step_rad);
  }

  /// Places just before the first beam are negative.
  double wrapped(double place) const {
    const double circle = 2 * kPi / grid_.scanner.angle_step_rad;
    const double most = (circle + static_cast<double>(grid_.beams) - 1) / 2;
    if (place > most) return place - circle;
    return place;
  }

  bool is_beam(double place) const { return place >= 0 && place < static_cast<double>(grid_.beams); }

  void set(double place, double range_m) {
    if (!is_beam(place)) return;
    float& kept_m = ranges_m_[static_cast<std::size_t>(place)];
    const auto seen_m = static_cast<float>(std::min(range_m, grid_.scanner.range_max_m));
    if (kept_m == kUnset || seen_m < kept_m) kept_m = seen_m;
  }

  const BeamGrid& grid_;
  std::vector<float> ranges_m_;
};

std::vector<float> as_measured(const BagScan& scan, const BeamGrid& grid) {
  std::vector<float> ranges_m = scan.ranges_m;
  const auto most_m = static_cast<float>(grid.scanner.range_max_m);
  for (float& range_m : ranges_m) range_m = std::min(range_m, most_m);
  return ranges_m;
}

}  // namespace

double end_of_scan_s(const BagScan& scan) {
  return ros::stamp_s(scan.time.stamp) +
         std::abs(scan.beams.period_s) * static_cast<double>(scan.ranges_m.size() - 1);
}

std::vector<float> fitted_ranges(const BagScan& scan, const BeamGrid& grid,
                                 const std::function<Pose2(double stamp_s)>& T_odom_vehicle) {
  const Pose2 T_odom_end = T_odom_vehicle(end_of_scan_s(scan));
  const Pose2 T_end_begin = between(T_odom_end, T_odom_vehicle(ros::stamp_s(scan.time.stamp)));
  if (has_the_beams_of(scan, grid) && !has_moved(T_end_begin)) return as_measured(scan, grid);
  const Pose2& T_vehicle_laser = grid.scanner.T_vehicle_laser;
  const Pose2 T_laser_odom = (T_odom_end * T_vehicle_laser).inverse();
  Fitting fitting(grid);
  std::vector<SeenPoint> points;
  std::vector<double> free_rad;  // where nothing was seen
  bool is_neighbour = false;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double range_m = scan.ranges_m[i];
    const double angle_rad = scan.beams.first_angle_rad + scan.beams.angle_step_rad * static_cast<double>(i);
    const Pose2 T_end_laser = T_laser_odom * T_odom_vehicle(reading_s(scan, i)) * T_vehicle_laser;
    const bool is_point = std::isfinite(range_m) && range_m > 0;
    if (is_point) {
      const Vec2 p = T_end_laser * Vec2(range_m * unit(angle_rad));
      points.push_back({p, heading_of(p)});
      if (is_neighbour) fitting.add_surface(points[points.size() - 2], points.back());
    } else if (range_m > 0) {
      free_rad.push_back(angle_rad + T_end_laser.theta);
    }
    is_neighbour = is_point;
  }
  for (const SeenPoint& point : points) fitting.add_reading(point.angle_rad, point.p_laser.norm());
  for (const double angle_rad : free_rad) fitting.add_reading(angle_rad, grid.scanner.range_max_m);
  return fitting.take_ranges();
}

}  // namespace aisle
