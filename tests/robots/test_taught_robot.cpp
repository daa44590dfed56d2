/// A robot that knows nothing of the program is shown the way round a corner by a person with a joystick, and
/// drives it alone by its camera; then its camera fails. In MuJoCo's physics and OpenGL's light: simulated.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>

#include "faulty_robot.hpp"

namespace aisle {
namespace {

using robots::delayed;
using robots::Fault;
using robots::frozen;
using robots::RunningRobot;
using robots::showing_the_same;
using testing::HasSubstr;
using testing::Lt;

using Point = std::array<double, 2>;

constexpr double kNearCorner_m = 1;  // there a vehicle may take another bend than the person
constexpr double kOffMax_m = 0.1;    // off the person's path, which is learned as lines and arcs

/// Of the default connection, and of what a navigator thinks of a camera.
constexpr double kCommandAge_s = 0.3, kImageAge_s = 0.5;

double off_segment_m(const Point& point, const Point& from, const Point& to) {
  const double x = to[0] - from[0], y = to[1] - from[1];
  const double length2 = std::max(x * x + y * y, 1e-12);
  const double share = std::clamp(((point[0] - from[0]) * x + (point[1] - from[1]) * y) / length2, 0.0, 1.0);
  return std::hypot(point[0] - from[0] - share * x, point[1] - from[1] - share * y);
}

double off_trace_m(const Point& point, const std::vector<Point>& trace) {
  double nearest_m = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < trace.size(); ++i)
    nearest_m = std::min(nearest_m, off_segment_m(point, trace[i - 1], trace[i]));
  return nearest_m;
}

class TaughtRobot : public FaultyRobot {
 public:
  /// The person's drive is recorded once, for all tests.
  static void SetUpTestSuite() {
    place = std::make_unique<TemporaryDirectory>();
    const std::string whole = read_bytes(AISLE_SOURCE_DIR "/worlds/l-corridor.yaml");
    write_bytes(in("corner.yaml"), whole.substr(0, whole.find("\nstart:")) +
                                       "\nstart: {at: [11, 1.05], heading_deg: 0}\n"
                                       "tour: [[11, 1.05], [14.95, 1.05], [14.95, 5]]\n");
    start(kFaster, "taught.json");
    start_relay();
    teach();
    robot->stop();
  }
  static void TearDownTestSuite() {
    FaultyRobot::TearDownTestSuite();
    place.reset();
  }

 protected:
  static constexpr const char* kFaster = "4";
  static constexpr const char* kRealTime = "1";

  static std::string in(const std::string& name) { return (place->path() / name).string(); }

  static void start(const char* speed, const std::string& report) {
    start_robot({"--camera", "320x240", "--speed", speed, "--report", in(report)}, in("corner.yaml"));
  }

  static void teach() {
    const std::string domain = std::to_string(drivers_domain());
    ASSERT_EQ(run_aisle({"connect", "init", "--domain", domain, "--out", in("robot.yaml"), "--footprint",
                         "0.25,0.1,0.3", "--speed-max", "0.4"})
                  .exit_code,
              0);
    RunningAisle teaching(
        {"teach", "--connect", in("robot.yaml"), "--operator", "joystick", "--out", in("shown"), "--json"});
    relay->wait_until([](const FaultRelay&) { return std::filesystem::exists(in("shown")); });
    RunningRobot person = RunningRobot::person(in("corner.yaml"), drivers_domain(), true);
    EXPECT_EQ(person.wait(), 0) << "the person got lost";
    const ProgramRun taught = teaching.wait();
    ASSERT_EQ(taught.exit_code, 0) << taught.out << taught.err;
    EXPECT_FALSE(taught.json()["figures"]["simulated"]);
  }

  /// @return where what was learned is
  static std::string learned(const std::string& method) {
    const std::string folder = in(method);
    const ProgramRun run = run_aisle({"learn", in("shown"), "--method", method, "--out", folder, "--force"});
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    return folder + "/building.json";
  }

  static Arguments navigating(const std::string& method) {
    return {"navigate", learned(method), "--method", method, "--connect", in("robot.yaml"), "--json"};
  }

  static nlohmann::json report(const std::string& name) {
    return nlohmann::json::parse(std::ifstream(in(name)));
  }

  /// Lateral error against the person's path, by the physics' truth, away from the corner.
  static double worst_off_m(const nlohmann::json& driven) {
    const auto taught = report("taught.json")["true_trace"].get<std::vector<Point>>();
    double worst_m = 0;
    for (const Point& point : driven["true_trace"].get<std::vector<Point>>()) {
      if (std::hypot(point[0] - 14.95, point[1] - 1.05) > kNearCorner_m)
        worst_m = std::max(worst_m, off_trace_m(point, taught));
    }
    return worst_m;
  }

  static void expect_it_repeats(const std::string& method) {
    const Arguments navigate = navigating(method);
    start(kFaster, "driven.json");
    const ProgramRun driven = run_aisle(navigate);
    EXPECT_EQ(driven.exit_code, 0) << driven.out << driven.err;
    EXPECT_FALSE(driven.json()["figures"]["simulated"]);
    EXPECT_FALSE(driven.json()["figures"].contains("tracking")) << "nobody knows the truth";
    ASSERT_EQ(robot->stop(), 0);
    const nlohmann::json truth = report("driven.json"), taught = report("taught.json");
    EXPECT_NEAR(truth["true_end"]["x_m"], taught["true_end"]["x_m"], kOffMax_m);
    EXPECT_NEAR(truth["true_end"]["y_m"], taught["true_end"]["y_m"], kOffMax_m);
    EXPECT_THAT(worst_off_m(truth), Lt(kOffMax_m));
    EXPECT_EQ(truth["contacts"]["count"], 0);
  }

  /// In real time, so that the program's own delays count as they are.
  static std::unique_ptr<RunningAisle> repeating() {
    Arguments navigate = navigating("landmarks");
    navigate.insert(navigate.end(), {"--set", "guard.wait_max_s=2"});
    start(kRealTime, "failed.json");
    auto aisle = std::make_unique<RunningAisle>(navigate);
    EXPECT_TRUE(is_driving()) << aisle->error_so_far();
    return aisle;
  }

  static void expect_standing_after(const Fault& fault, double limit_s) {
    const double at_s = relay->robot_time_s();
    relay->set("/camera/image_raw", fault);
    expect_standing_from(at_s + limit_s);
  }

  static void expect_ended(RunningAisle& aisle, const std::string& because) {
    const ProgramRun run = aisle.wait();
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_THAT(run.json()["figures"]["why"].get<std::string>(), HasSubstr(because)) << run.err;
  }

  static inline std::unique_ptr<TemporaryDirectory> place;
};

TEST_F(TaughtRobot, RepeatsByLandmarks) {
  expect_it_repeats("landmarks");
}

TEST_F(TaughtRobot, RepeatsBySections) {
  expect_it_repeats("sections");
}

TEST_F(TaughtRobot, StandsAndSaysWhyWhenItsImagesStop) {
  const auto aisle = repeating();
  expect_standing_after(frozen(), kCommandAge_s);
  expect_ended(*aisle, "/camera/image_raw silent for 1.0 s");
}

TEST_F(TaughtRobot, StandsAndSaysWhyWhenItsImagesStayTheSame) {
  const auto aisle = repeating();
  expect_standing_after(showing_the_same(), kImageAge_s);
  expect_ended(*aisle, "camera front is frozen");
}

TEST_F(TaughtRobot, IsHeldWhileItsImagesAreLate) {
  const auto aisle = repeating();
  expect_standing_after(delayed(0.7), kCommandAge_s);
  EXPECT_TRUE(says(*aisle, "held: /camera/image_raw is far behind /odom")) << aisle->error_so_far();
  relay->heal();
  expect_it_drives_on(*aisle);
  aisle->signal(SIGTERM);
  EXPECT_EQ(aisle->wait().exit_code, 130);
}

TEST_F(TaughtRobot, IsRefusedToWhoCannotDriveItOrWantsOtherCameras) {
  start(kFaster, "unfit.json");
  const ProgramRun drive = run_aisle({"drive", "--connect", in("robot.yaml"), "--operator", "scripted"});
  EXPECT_EQ(drive.exit_code, 2);
  EXPECT_THAT(drive.err, HasSubstr("a scripted person cannot drive a robot"));
  const ProgramRun room = run_aisle({"teach", "--connect", in("robot.yaml"), "--method", "rooms",
                                     "--operator", "joystick", "--out", in("room")});
  EXPECT_EQ(room.exit_code, 2);
  EXPECT_THAT(room.err, HasSubstr("there is no camera top"));
}

}  // namespace
}  // namespace aisle
