#include "logs/mrpt_objects.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace aisle {
namespace {

constexpr std::uint32_t kRawlogReadingsMax = 100'000;

/// Ticks of 100 ns since 1601; 0: none. In seconds since 1970.
double read_stamp_s(MrptStream& stream) {
  constexpr double kTicksPerSecond = 1e7;
  constexpr std::uint64_t kTicksUntil1970 = 116'444'736'000'000'000;
  const auto ticks = stream.read<std::uint64_t>();
  if (ticks < kTicksUntil1970) return static_cast<double>(ticks) / kTicksPerSecond;
  const std::uint64_t since_1970 = ticks - kTicksUntil1970;
  return static_cast<double>(since_1970) / kTicksPerSecond;
}

/// A matrix object: rows, columns, elements row by row. `CMatrix`, later `CMatrixF`, has floats.
template <class Element>
std::vector<double> read_matrix_object(MrptStream& stream) {
  const MrptHeader header = stream.read_header();
  if (stream.ok() && (!header.class_name.starts_with("CMatrix") || header.version != 0)) {
    stream.fail(
        fmt::format("has a {} of version {} where a matrix should be", header.class_name, header.version));
  }
  const auto rows = stream.read<std::uint32_t>(), columns = stream.read<std::uint32_t>();
  constexpr std::uint32_t kSideMax = 100;
  if (rows > kSideMax || columns > kSideMax) stream.fail("has an absurdly large matrix");
  std::vector<double> elements;
  for (std::uint32_t i = 0; stream.ok() && i < rows * columns; ++i)
    elements.push_back(stream.read<Element>());
  stream.read_end_of_object();
  return elements;
}

/// From the first two columns and the last element of a rotation matrix.
SensorPose flat_pose(double x, double y, double r00, double r10, double r22) {
  return {{x, y, std::atan2(r10, r00)}, r22};
}

SensorPose from_homogeneous(MrptStream& stream, const std::vector<double>& matrix) {
  if (matrix.size() != 16) {
    stream.fail("has a pose that is no 4 x 4 matrix");
    return {};
  }
  return flat_pose(matrix[3], matrix[7], matrix[0], matrix[4], matrix[10]);
}

SensorPose from_quaternion(double x, double y, double w, double i, double j, double k) {
  return flat_pose(x, y, 1 - 2 * (j * j + k * k), 2 * (i * j + w * k), 1 - 2 * (i * i + j * j));
}

template <std::size_t count>
std::array<double, count> read_doubles(MrptStream& stream) {
  std::array<double, count> values;
  for (double& value : values) value = stream.read<double>();
  return values;
}

/// The object CPose3D.
SensorPose read_pose3(MrptStream& stream) {
  const int version = stream.read_header_of("CPose3D", 3);
  SensorPose pose;
  if (version == 0) {
    pose = from_homogeneous(stream, read_matrix_object<float>(stream));
  } else if (version == 1) {
    pose = from_homogeneous(stream, read_matrix_object<double>(stream));
  } else if (version == 2) {
    const auto [x, y, z, w, i, j, k] = read_doubles<7>(stream);
    pose = from_quaternion(x, y, w, i, j, k);
  } else {
    const auto [x, y, z, r00, r01, r02, r10, r11, r12, r20, r21, r22] = read_doubles<12>(stream);
    pose = flat_pose(x, y, r00, r10, r22);
  }
  stream.read_end_of_object();
  if (stream.ok() && !(pose.flat.is_finite() && std::isfinite(pose.up_z)))
    stream.fail("has a pose that is not finite");
  return pose;
}

/// The object CPose2D.
Pose2 read_pose2(MrptStream& stream) {
  const int version = stream.read_header_of("CPose2D", 1);
  Pose2 pose;
  for (double* value : {&pose.x, &pose.y, &pose.theta}) {
    *value = version == 0 ? double{stream.read<float>()} : stream.read<double>();
  }
  stream.read_end_of_object();
  constexpr double kPoseMax_m = 1e7;
  if (stream.ok() &&
      !(pose.is_finite() && pose.position().norm() < kPoseMax_m && std::abs(pose.theta) < 1e6)) {
    stream.fail("has a pose that is absurdly large or not finite");
  }
  return pose;
}

/// The mean of an object CPosePDFGaussian or CPosePDFGaussianInf.
Pose2 read_gaussian_mean(MrptStream& stream) {
  constexpr std::size_t kSymmetricElements = 6;
  const MrptHeader header = stream.read_header();
  if (!stream.ok()) return {};
  const bool is_gaussian = header.class_name == "CPosePDFGaussian" && header.version <= 2;
  const bool is_inverse = header.class_name == "CPosePDFGaussianInf" && header.version == 0;
  if (!is_gaussian && !is_inverse) {
    stream.fail(fmt::format("has a movement as a {} of version {}, which is not read", header.class_name,
                            header.version));
    return {};
  }
  const Pose2 mean = read_pose2(stream);
  if (is_gaussian && header.version == 0) {
    read_matrix_object<float>(stream);
  } else {
    stream.skip(kSymmetricElements * (is_gaussian && header.version == 1 ? sizeof(float) : sizeof(double)));
  }
  stream.read_end_of_object();
  return mean;
}

/// What follows the raw odometry of a movement: how its uncertainty was modelled.
void skip_motion_model(MrptStream& stream, int version) {
  constexpr std::size_t kWord = 4;
  if (version == 2) return stream.skip(44);
  const std::size_t gaussian = version == 3 ? 5 : 6, thrun = version >= 5 ? 6 : 4;
  stream.skip(kWord * (1 + gaussian + 1 + thrun));
}

constexpr std::size_t kTwoTicks = 8;
constexpr std::size_t kTwoFloats = 8;  // speed and turn rate
constexpr std::size_t kTwist = 3 * sizeof(double);

/// @param size  of the part that a flag before it announces
/// @param always  it is there whatever the flag says
void skip_announced(MrptStream& stream, std::size_t size, bool always) {
  const bool is_there = stream.read<unsigned char>() != 0;
  if (is_there || always) stream.skip(size);
}

void read_scan_readings(MrptStream& stream, bool with_validity, MrptScan& scan) {
  const auto count = stream.read<std::uint32_t>();
  if (count > kRawlogReadingsMax) return stream.fail(fmt::format("has a scan of {} readings", count));
  if (!stream.has(count, sizeof(float))) return stream.skip(count * sizeof(float));
  scan.readings_m.resize(count);
  for (float& reading_m : scan.readings_m) reading_m = stream.read<float>();
  if (with_validity) scan.valid = stream.read_bytes(count);
}

}  // namespace

MrptScan read_mrpt_scan(MrptStream& stream, int version) {
  constexpr std::size_t kStandardDeviation = sizeof(float), kBeamAperture = sizeof(float);
  MrptScan scan;
  scan.aperture_rad = stream.read<float>();
  scan.counter_clockwise = stream.read<unsigned char>() != 0;
  scan.range_max_m = stream.read<float>();
  scan.T_vehicle_laser = read_pose3(stream);
  if (version < 6) read_matrix_object<float>(stream);  // the pose's covariance
  read_scan_readings(stream, version >= 1, scan);
  if (version >= 2) stream.skip(kStandardDeviation);
  if (version >= 3) scan.stamp_s = read_stamp_s(stream);
  if (version >= 4) stream.skip(kBeamAperture);
  if (version >= 5) {
    scan.label = stream.read_string();
    stream.skip(sizeof(double));  // change of pitch
  }
  if (version >= 7 && stream.read<unsigned char>() != 0) {
    stream.skip(scan.readings_m.size() * sizeof(std::int32_t));  // intensities
  }
  stream.read_end_of_object();
  return scan;
}

MrptOdometry read_mrpt_odometry(MrptStream& stream, int version) {
  MrptOdometry odometry;
  odometry.T_odom_vehicle = read_pose2(stream);
  stream.read_string();  // label
  odometry.stamp_s = read_stamp_s(stream);
  if (version >= 1) {
    skip_announced(stream, kTwoTicks, version == 1);
    skip_announced(stream, version == 1 ? kTwoFloats : kTwist, version == 1);
  }
  stream.read_end_of_object();
  return odometry;
}

MrptMovement read_mrpt_movement(MrptStream& stream, int version) {
  constexpr std::uint32_t kByOdometry = 0;
  MrptMovement movement;
  if (version <= 1) {
    movement.motion = read_gaussian_mean(stream);
    movement.by_odometry = stream.read<std::uint32_t>() == kByOdometry;
  } else {
    movement.by_odometry = stream.read<std::uint32_t>() == kByOdometry;
    movement.motion = movement.by_odometry ? read_pose2(stream) : read_gaussian_mean(stream);
    if (movement.by_odometry) skip_motion_model(stream, version);
  }
  if (version >= 1) {
    skip_announced(stream, version < 7 ? kTwoFloats : kTwist, version < 7);
    skip_announced(stream, kTwoTicks, version < 7);
  }
  if (version >= 6) read_stamp_s(stream);
  stream.read_end_of_object();
  return movement;
}

}  // namespace aisle
