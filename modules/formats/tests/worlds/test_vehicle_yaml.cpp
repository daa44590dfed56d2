#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <filesystem>

#include "aisle/core/angle.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::filesystem::path kVehicles = std::filesystem::path(AISLE_SOURCE_DIR) / "vehicles";

std::string vehicle_problems(const std::string& text) {
  const auto vehicle = parse_vehicle("format: aisle.vehicle\nversion: 1\n" + text, "cart.yaml");
  return vehicle.ok() ? "" : to_string(vehicle.problems());
}

VehicleModel shipped(const std::string& name) {
  auto vehicle = read_vehicle(kVehicles / name);
  EXPECT_TRUE(vehicle.ok()) << to_string(vehicle.problems());
  return *vehicle;
}

TEST(VehicleYaml, AFileWithoutFieldsIsTheDefaultVehicle) {
  const auto vehicle = parse_vehicle("format: aisle.vehicle\nversion: 1\n", "cart.yaml");
  ASSERT_TRUE(vehicle.ok());
  EXPECT_THAT(vehicle->description.cameras, IsEmpty());
  EXPECT_FALSE(vehicle->description.scanner);
  EXPECT_FALSE(vehicle->description.laser_markers);
  EXPECT_EQ(vehicle->description.front_steered.wheelbase_m, FrontSteered{}.wheelbase_m);
}

TEST(VehicleYaml, PartsAreCreatedByTheirKeys) {
  const auto vehicle = parse_vehicle(
      "format: aisle.vehicle\nversion: 1\nscanner: {}\nlaser_markers: {height_m: 0.4}\n"
      "cameras: {left: {pan_deg: 90}, ahead: {}}\nsimulated: {cameras: {left: {noise_sigma: 4}}}\n",
      "cart.yaml");
  ASSERT_TRUE(vehicle.ok()) << to_string(vehicle.problems());
  EXPECT_THAT(vehicle->description.cameras,
              ElementsAre(Field(&CameraDescription::name, "left"), Field(&CameraDescription::name, "ahead")));
  EXPECT_DOUBLE_EQ(vehicle->description.cameras[0].mount.pan_rad, 90 * kDegree);
  EXPECT_DOUBLE_EQ(vehicle->description.scanner->range_max_m, 30);
  EXPECT_DOUBLE_EQ(vehicle->description.laser_markers->height_m, 0.4);
  EXPECT_DOUBLE_EQ(vehicle->simulated.cameras.at("left").noise_sigma, 4);
}

TEST(VehicleYaml, EveryProblemIsNamedWithItsPlace) {
  EXPECT_EQ(vehicle_problems("limits:\n  speed_max_mps: fast\n  steering_max_deg: 200\nweels: 4\n"),
            "cart.yaml:4: limits.speed_max_mps: 'fast' is not a number\n"
            "cart.yaml:5: limits.steering_max_deg: 200 is outside 1 .. 89\n"
            "cart.yaml:6: weels: unknown key (nearest known key: cycle_s)");
}

TEST(VehicleYaml, WhatIsNoVehicleIsRefused) {
  EXPECT_THAT(to_string(parse_vehicle("[1, 2]", "a").problems()), HasSubstr("a:1: is not a vehicle"));
  EXPECT_THAT(to_string(parse_vehicle("a: [", "a").problems()), HasSubstr("is not YAML"));
  EXPECT_THAT(to_string(parse_vehicle("version: 2\n", "a").problems()),
              HasSubstr("a:1: format: is missing\na:1: version: is not 1"));
}

TEST(VehicleYaml, TheNameIsOneLineOfText) {
  for (const char* name : {"\"two\\nlines\"", "\"\\0\"", "\"bell \\a\"", "\"\x93\x9e\""}) {
    EXPECT_THAT(vehicle_problems(fmt::format("name: {}\n", name)),
                HasSubstr("cart.yaml:3: name: is not a line of UTF-8 text of at most 64 bytes"));
  }
  EXPECT_EQ(vehicle_problems("name: \"Wägelchen 台車\"\n"), "");
}

TEST(VehicleYaml, CamerasHaveOneUsableNameEach) {
  EXPECT_THAT(vehicle_problems("cameras: {a/b: {}}\n"),
              HasSubstr("cart.yaml:3: cameras.a/b: is not a camera name"));
  EXPECT_THAT(vehicle_problems("cameras:\n  a: {}\n  a: {z_m: 1}\n"),
              HasSubstr("5: cameras.a: is given twice"));
  EXPECT_THAT(vehicle_problems("cameras: [1]\n"), HasSubstr("cart.yaml:3: cameras: a list is not a value"));
  EXPECT_THAT(vehicle_problems("simulated: {cameras: {a: {exposure: 1}}}\n"),
              HasSubstr("simulated.cameras.a.exposure: unknown key"));
}

TEST(VehicleYaml, WrittenVehiclesReadAsTheyWere) {
  for (const char* name : {"alv.yaml", "alv-scanner.yaml", "jackal.yaml", "mini.yaml", "turtlebot.yaml"}) {
    const VehicleModel vehicle = shipped(name);
    const std::string text = vehicle_yaml(vehicle);
    const auto again = parse_vehicle(text, name);
    ASSERT_TRUE(again.ok()) << to_string(again.problems());
    EXPECT_EQ(vehicle_yaml(*again), text);
    EXPECT_EQ(vehicle_yaml(again->description), vehicle_yaml(vehicle.description));
  }
}

TEST(VehicleYaml, EveryLensIsReadAsItWasWritten) {
  VehicleDescription vehicle;
  const CameraIntrinsics rational{.k1 = 90, .model = LensModel::kRationalPolynomial, .k4 = 89.5, .k6 = 1e-9};
  const CameraIntrinsics fisheye{.k1 = 0.1, .model = LensModel::kEquidistant, .k4 = -0.01};
  const CameraIntrinsics plain_fisheye{.model = LensModel::kEquidistant};
  const std::array lenses = {CameraIntrinsics{.k3 = 0.2}, rational, fisheye, plain_fisheye};
  for (std::size_t i = 0; i < lenses.size(); ++i)
    vehicle.cameras.push_back({.name = fmt::format("camera_{}", i), .intrinsics = lenses[i]});
  const std::string text = vehicle_yaml(vehicle);
  const auto again = parse_vehicle(text, "cart.yaml");
  ASSERT_TRUE(again.ok()) << to_string(again.problems());
  for (std::size_t i = 0; i < lenses.size(); ++i)
    EXPECT_EQ(again->description.cameras[i].intrinsics, lenses[i]) << i;
  vehicle.cameras.resize(1);
  EXPECT_THAT(vehicle_yaml(vehicle), testing::Not(HasSubstr("is_fisheye")));
}

TEST(VehicleYaml, TheDescriptionAloneDoesNotContainTheTruth) {
  EXPECT_THAT(vehicle_yaml(shipped("alv.yaml").description), testing::Not(HasSubstr("simulated")));
}

TEST(VehicleYaml, TheMiniVehicleIsThatOfThePaper) {
  const VehicleDescription mini = shipped("mini.yaml").description;
  EXPECT_TRUE(mini.is_differential);
  EXPECT_EQ(mini.differential.steps_per_turn, 200);
  EXPECT_DOUBLE_EQ(mini.differential.wheel_radius_m, 0.043);
  EXPECT_DOUBLE_EQ(mini.differential.wheel_separation_m, 0.186);
  EXPECT_DOUBLE_EQ(mini.footprint.front_m + mini.footprint.rear_m, 0.22);
  ASSERT_THAT(mini.cameras, SizeIs(1));
  EXPECT_EQ(mini.cameras[0].width_px, 320);
}

TEST(VehicleYaml, TheRobotsForSaleFitThroughDoorsAndCarryTheirScannersOnThem) {
  for (const char* name : {"jackal.yaml", "turtlebot.yaml"}) {
    const VehicleModel vehicle = shipped(name);
    EXPECT_TRUE(vehicle.description.is_differential) << name;
    EXPECT_LT(vehicle.description.footprint.width_m, 0.6) << name;
    ASSERT_TRUE(vehicle.description.scanner) << name;
    EXPECT_LT(off_footprint_m(vehicle.description.footprint,
                              vehicle.description.scanner->T_vehicle_laser.position()),
              0)
        << name;
    EXPECT_LT(vehicle.simulated.scanner.height_m, vehicle.description.footprint.height_m) << name;
  }
}

TEST(VehicleYaml, TheCartHasTheCamerasOfRoomsAndCorridors) {
  const VehicleDescription alv = shipped("alv.yaml").description;
  EXPECT_NEAR(alv.footprint.front_m + alv.footprint.rear_m, 1.2, 1e-12);
  EXPECT_DOUBLE_EQ(alv.footprint.width_m, 0.6);
  EXPECT_THAT(
      alv.cameras,
      ElementsAre(Field(&CameraDescription::name, "corridor"), Field(&CameraDescription::name, "top"),
                  Field(&CameraDescription::name, "middle"), Field(&CameraDescription::name, "bottom")));
  EXPECT_TRUE(alv.laser_markers);
}

}  // namespace
}  // namespace aisle
