#pragma once
/// Small sessions to test with.

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "aisle/core/random.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/formats/whole_file.hpp"

namespace aisle {

/// A directory of the test's own, empty at first and removed at its end.
class SessionPlace {
 public:
  SessionPlace() {
    std::string pattern = (std::filesystem::temp_directory_path() / "aisle-session-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  SessionPlace(const SessionPlace&) = delete;
  SessionPlace& operator=(const SessionPlace&) = delete;
  ~SessionPlace() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Front-steered, with a grey camera "front", a colour camera "left", and a scanner of nine beams.
inline VehicleDescription sample_vehicle() {
  VehicleDescription vehicle;
  vehicle.name = "sample";
  vehicle.cameras.resize(2);
  vehicle.cameras[0].name = "front";
  vehicle.cameras[1].name = "left";
  for (CameraDescription& camera : vehicle.cameras) {
    camera.width_px = 64;
    camera.height_px = 48;
    camera.intrinsics = {.fx_px = 50, .fy_px = 51, .cx_px = 31.5, .cy_px = 23.5, .k1 = -0.1};
    camera.mount.p_vehicle_camera = {0.6, 0, 1.1};
  }
  vehicle.cameras[1].mount.pan_rad = 90 * kDegree;
  vehicle.scanner = LaserScanner{-80 * kDegree, 20 * kDegree, 10, {0.5, 0, 0}};
  return vehicle;
}

/// A smooth image with some noise.
inline Image sample_image(int width, int height, int channels, Random& random) {
  Image image(width, height, channels);
  const double phase = random.uniform(0, 6);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) {
    const double wave = std::sin(phase + static_cast<double>(i) * 0.01);
    image.bytes[i] = static_cast<std::uint8_t>(128 + 90 * wave + random.uniform(-8, 8));
  }
  return image;
}

/// The cycle number `index`, from 0: everything that an observation may hold turns up in ten of them.
inline Observation sample_observation(int index) {
  Random random(static_cast<std::uint64_t>(index) + 1);
  Observation observation;
  observation.stamp_s = 0.1 * (index + 1);
  observation.images.push_back(
      {"front", observation.stamp_s - 0.02, std::make_shared<Image>(sample_image(64, 48, 1, random))});
  if (index % 2 == 0) {
    observation.images.push_back(
        {"left", observation.stamp_s - 0.01, std::make_shared<Image>(sample_image(64, 48, 3, random))});
  }
  observation.odometry = FrontSteeredMotion{random.uniform(0, 0.1), random.normal(0.1)};
  if (index % 3 == 0) {
    observation.scan = RangeScan{observation.stamp_s - 0.005, {}};
    for (int beam = 0; beam < 9; ++beam)
      observation.scan->ranges_m.push_back(static_cast<float>(random.uniform(0, 10)));
  }
  if (index % 5 == 2) {
    observation.operator_input.requested = Command{.speed_mps = random.uniform(), .steering_rad = -0.1};
    observation.operator_input.marks = {{Mark::Kind::kTurningBegins, "6"},
                                        {Mark::Kind::kPlace, "Büro \"1\""}};
    observation.operator_input.goal_changes = {{.added = "Büro \"1\""}, {.removed = 2}};
  }
  observation.operator_input.quit = index % 10 == 9;
  observation.operator_input.gives_up = index % 20 == 9;
  observation.bumper_pressed = index % 10 == 4;
  return observation;
}

inline Decision sample_decision(int index) {
  Random random(static_cast<std::uint64_t>(index) + 1000);
  return {.command = {.speed_mps = random.uniform(), .steering_rad = random.normal(0.2)},
          .status = NavigatorStatus::kGoing,
          .state = "following",
          .why = "cycle " + std::to_string(index)};
}

inline SessionOrigin sample_origin() {
  return {.navigator = "sample", .parameters = {{"speed_mps", "0.5"}}, .seed = 7, .simulated = true};
}

/// Records that many cycles with the truth; returns what the record gave back for each.
inline std::vector<Observation> record_sample(const std::filesystem::path& directory, int cycles,
                                              const ImageCoding& coding = {}) {
  auto record = SessionRecord::create(directory, false, sample_vehicle(), sample_origin(), coding);
  std::vector<Observation> kept;
  for (int i = 0; i < cycles; ++i) {
    const Observation observation = sample_observation(i);
    (void)record->keep_truth(observation.stamp_s, {0.1 * i, 0, 0.01 * i});
    kept.push_back(*record->keep(observation));
    (void)record->keep(sample_decision(i));
  }
  (void)record->close();
  return kept;
}

}  // namespace aisle
