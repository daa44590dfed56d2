#include "aisle/learning/walls/online_mapping.hpp"

#include "aisle/learning/walls/scan_geometry.hpp"
#include "walls/scan_mapping.hpp"

namespace aisle {

class OnlineMapping::Work {
 public:
  Work(const MapParams& params, const LaserScanner& laser)
      : T_vehicle_laser(laser.T_vehicle_laser),
        segmenter(scan_geometry(laser), params.segments),
        mapping(params) {}

  Pose2 T_vehicle_laser;
  RangeSegmenter segmenter;
  ScanMapping mapping;
  std::vector<SensedSegment> seen;
};

OnlineMapping::OnlineMapping(const MapParams& params, const LaserScanner& laser)
    : work_(std::make_unique<Work>(params, laser)) {}

OnlineMapping::~OnlineMapping() = default;

bool OnlineMapping::take_scan(std::span<const float> ranges_m, const Pose2& T_last_now) {
  const Pose2 T_laser_vehicle = work_->T_vehicle_laser.inverse();
  work_->segmenter.extract(ranges_m, work_->seen);
  const bool closed = work_->mapping.step(work_->seen, T_laser_vehicle * T_last_now * work_->T_vehicle_laser);
  T_map_vehicle_ = work_->mapping.T_map_sensor() * T_laser_vehicle;
  return closed;
}

std::optional<Pose2> OnlineMapping::lay_again(std::size_t scan, const Pose2& T_map_guess) {
  const auto T_map_sensor = work_->mapping.lay_again(scan, T_map_guess * work_->T_vehicle_laser);
  if (!T_map_sensor) return std::nullopt;
  return *T_map_sensor * work_->T_vehicle_laser.inverse();
}

std::vector<Pose2> OnlineMapping::T_map_vehicle_of_all() const {
  std::vector<Pose2> poses = work_->mapping.T_map_sensor_of_all();
  const Pose2 T_laser_vehicle = work_->T_vehicle_laser.inverse();
  for (Pose2& pose : poses) pose = pose * T_laser_vehicle;
  return poses;
}

}  // namespace aisle
