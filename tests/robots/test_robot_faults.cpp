/// What happens when something goes wrong between a robot and the program, or on one of both sides: every row
/// of docs/explanation/connection.md. The robot is simulated in MuJoCo; times are of its clock.
#include <gmock/gmock.h>

#include <array>
#include <vector>

#include "faulty_robot.hpp"

namespace aisle {
namespace {

using robots::delayed;
using robots::Fault;
using robots::frozen;
using robots::Odometry;
using robots::Participant;
using robots::Quality;
using robots::rewritten;
using robots::stamped_later;
using testing::AllOf;
using testing::HasSubstr;

/// Of the default connection.
constexpr double kCommandAge_s = 0.3, kOdometrySilent_s = 0.25, kOwnTimeout_s = 0.5;

Fault displaced(double x_m) {
  return rewritten([x_m](const std::string& bytes) {
    auto odometry = robots::from_cdr<Odometry>(bytes).value();
    odometry.pose.position.x += x_m;
    return robots::to_cdr(odometry);
  });
}

Fault begun_again(double origin_x_m, double origin_y_m) {
  return rewritten([=](const std::string& bytes) {
    auto odometry = robots::from_cdr<Odometry>(bytes).value();
    odometry.pose.position = {odometry.pose.position.x - origin_x_m, odometry.pose.position.y - origin_y_m,
                              0};
    odometry.pose.orientation = {};
    return robots::to_cdr(odometry);
  });
}

Fault garbled() {
  return rewritten([](const std::string& bytes) { return bytes.substr(0, bytes.size() / 2); });
}

/// What the vehicle is held for, and drives on after: all in one run of the program.
class HeldRobot : public FaultyRobot {
 public:
  static void TearDownTestSuite() {
    end(SIGKILL);
    FaultyRobot::TearDownTestSuite();
  }

 protected:
  void SetUp() override {
    FaultyRobot::SetUp();
    if (!aisle) aisle = exploring(connection("robot.yaml", "emergency_stops: [{topic: stop}]\n"));
    ASSERT_TRUE(is_driving()) << aisle->error_so_far();
  }
  void TearDown() override {
    relay->heal();
    if (aisle) expect_it_drives_on(*aisle);
    if (HasFailure()) end(SIGKILL);  // the next test starts another robot
  }

  static ProgramRun end(int signal) {
    if (!aisle) return {};
    aisle->signal(signal);
    const ProgramRun run = aisle->wait();
    aisle.reset();
    return run;
  }

  /// @param limit_s  after which what goes on now is a fault
  static void expect_held(double limit_s, const std::string& because) {
    expect_standing_from(relay->robot_time_s() + limit_s);
    EXPECT_TRUE(says(*aisle, because)) << aisle->error_so_far();
  }

  static inline std::unique_ptr<RunningAisle> aisle;
};

TEST_F(HeldRobot, WhileTheEmergencyStopIsPressed) {
  stop->publish({true});
  expect_held(0, "the emergency stop /stop is pressed");
  stop->publish({false});
}

TEST_F(HeldRobot, WhileItsOdometryIsSilent) {
  relay->set("/odom", frozen());
  relay->set_in(kOdometrySilent_s + kStandsWithin_s + kWatched_s, "/odom", {});
  expect_held(kOdometrySilent_s, "/odom is silent");
}

TEST_F(HeldRobot, WhenItsOdometryLeaps) {
  relay->set("/odom", displaced(1));
  expect_held(0, "its odometry leapt");
  expect_it_drives_on(*aisle);
  end(SIGKILL);  // back would be a second leap
}

TEST_F(HeldRobot, WhenItsClockJumpsAhead) {
  for (const char* topic : {"/clock", "/odom", "/scan"}) relay->set(topic, stamped_later(5));
  expect_held(0, "jumped ahead by 5.");
  expect_it_drives_on(*aisle);
  end(SIGKILL);  // back is another test
}

TEST_F(HeldRobot, WhileItsScansAreLate) {
  relay->set("/scan", delayed(0.7));
  expect_held(kCommandAge_s, "/scan is far behind /odom");
}

TEST_F(HeldRobot, WhileAnotherProgramSendsCommands) {
  const Participant participant(drivers_domain());
  const robots::Publisher<robots::Twist> joystick(participant, "/cmd_vel", Quality::kDefault);
  expect_held(0, "another program sends commands on /cmd_vel");
}

TEST_F(HeldRobot, WhileItHangs) {
  robot->signal(SIGSTOP);
  EXPECT_TRUE(says(*aisle, "held: /clock stands still"));
  robot->signal(SIGCONT);
}

TEST_F(HeldRobot, ByItsOwnDriverWhileTheProgramHangs) {
  aisle->signal(SIGSTOP);
  expect_standing_from(relay->robot_time_s() + kOwnTimeout_s);
  aisle->signal(SIGCONT);
}

TEST_F(HeldRobot, ByItsOwnDriverWhileCommandsAreLost) {
  relay->set("/cmd_vel", frozen());
  expect_standing_from(relay->robot_time_s() + kOwnTimeout_s);
}

TEST_F(HeldRobot, NotByMessagesThatAreLostLateDoubledAndInAnotherOrder) {
  Fault poor;
  poor.lost_share = 0.1;
  poor.delay_spread_s = 0.1;
  poor.copies = 2;
  for (const char* topic : {"/clock", "/odom", "/scan", "/cmd_vel"}) relay->set(topic, poor);
  const double from_m = relay->driven_m();
  EXPECT_TRUE(relay->wait_until([&](const FaultRelay& r) { return r.driven_m() > from_m + 0.8; }));
}

TEST_F(HeldRobot, ForGoodWhenTheProgramIsTerminated) {
  const double at_s = relay->robot_time_s();
  const ProgramRun run = end(SIGTERM);
  expect_standing_from(at_s);
  EXPECT_EQ(run.exit_code, 130);
}

using StoppedRobot = FaultyRobot;

TEST_F(StoppedRobot, IsNotMovedWhenItsLatchedEmergencyStopWasPressedBefore) {
  const robots::Publisher<robots::Bool> latched(*drivers_side, "/latched", Quality::kLatched);
  latched.publish({true});
  const auto aisle = exploring(connection("robot.yaml", "emergency_stops: [{topic: latched}]\n"));
  const double last_motion_s = relay->last_motion_s();
  EXPECT_TRUE(says(*aisle, "held: the emergency stop /latched is pressed")) << aisle->error_so_far();
  EXPECT_EQ(relay->last_motion_s(), last_motion_s);
  latched.publish({false});
  expect_it_drives_on(*aisle);
  aisle->signal(SIGTERM);
  EXPECT_EQ(aisle->wait().exit_code, 130);
}

/// What ends the mission, each in a run of its own.
struct Ending {
  const char* name;
  std::function<void(FaultRelay&)> begin;
  double limit_s;
  const char* because;
};

void PrintTo(const Ending& ending, std::ostream* out) {
  *out << ending.name;
}

class EndedMission : public FaultyRobot, public testing::WithParamInterface<Ending> {};

TEST_P(EndedMission, StandsStillAndSaysWhy) {
  const Ending& ending = GetParam();
  const auto aisle = exploring(connection());
  ASSERT_TRUE(is_driving()) << aisle->error_so_far();
  const double at_s = relay->robot_time_s();
  ending.begin(*relay);
  expect_standing_from(at_s + ending.limit_s);
  const ProgramRun run = aisle->wait();
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(run.json()["figures"]["ended_because"].get<std::string>(), HasSubstr(ending.because))
      << run.err;
}

const std::vector<Ending> kEndings = {
    {"ScansFrozen", [](FaultRelay& r) { r.set("/scan", frozen()); }, kCommandAge_s, "/scan silent for 1.0 s"},
    {"OdometryFrozen", [](FaultRelay& r) { r.set("/odom", frozen()); }, kOdometrySilent_s,
     "/odom silent for 1.0 s"},
    {"OdometryLeapsTwice",
     [](FaultRelay& r) {
       r.set("/odom", displaced(1));
       r.set_in(0.5, "/odom", displaced(3));
     },
     0, "its odometry leapt twice in 10 s"},
    {"StampsOfScansJumpBack", [](FaultRelay& r) { r.set("/scan", stamped_later(-5)); }, 0,
     "/scan jumped back by"},
    {"StampsOfOdometryJumpBack", [](FaultRelay& r) { r.set("/odom", stamped_later(-5)); }, 0,
     "/odom jumped back by"},
    {"ClockJumpsBack", [](FaultRelay& r) { r.set("/clock", stamped_later(-5)); }, 0, "/clock jumped back by"},
    {"ScansGarbled", [](FaultRelay& r) { r.set("/scan", garbled()); }, kCommandAge_s,
     "sensor_msgs/msg/LaserScan"},
    {"OdometryGarbled", [](FaultRelay& r) { r.set("/odom", garbled()); }, kOdometrySilent_s,
     "nav_msgs/msg/Odometry"}};

INSTANTIATE_TEST_SUITE_P(Robot, EndedMission, testing::ValuesIn(kEndings),
                         [](const auto& ending) { return ending.param.name; });

using RestartedRobot = FaultyRobot;

TEST_F(RestartedRobot, EndsTheMissionByItsClock) {
  const auto aisle = exploring(connection());
  ASSERT_TRUE(is_driving());
  robot.reset();
  start_robot();
  const ProgramRun run = aisle->wait();
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(run.json()["figures"]["ended_because"].get<std::string>(), HasSubstr("/clock jumped back by"));
  EXPECT_LT(relay->last_motion_s(), kStandsWithin_s)
      << "the new one may hear the last command to the old one";
}

TEST_F(RestartedRobot, EndsTheMissionByItsOdometry) {
  const auto aisle = exploring(connection());
  ASSERT_TRUE(is_driving());
  const double from_m = relay->driven_m();
  ASSERT_TRUE(relay->wait_until([&](const FaultRelay& r) { return r.driven_m() > from_m + 1; }));
  const double at_s = relay->robot_time_s();
  const robots::Vector3 at = relay->position();
  relay->set("/odom", begun_again(at.x, at.y));
  expect_standing_from(at_s);
  const ProgramRun run = aisle->wait();
  EXPECT_THAT(run.json()["figures"]["ended_because"].get<std::string>(),
              HasSubstr("its odometry began again at zero"));
}

using RobotAtTheStart = FaultyRobot;

/// All at once: each waits ten seconds before it gives up.
TEST_F(RobotAtTheStart, IsRefusedByNameAndNotMoved) {
  const Participant participant(drivers_domain());
  const robots::Publisher<robots::Image> picture(participant, "/picture", Quality::kSensor);
  const robots::Publisher<robots::LaserScan> quiet(participant, "/quiet", Quality::kSensor);
  const robots::Publisher<robots::Twist> joystick(participant, "/driven", Quality::kDefault);
  const robots::Subscription<robots::Twist> wheels(participant, "/driven", Quality::kDefault);
  const std::vector<std::array<std::string, 3>> refusals = {
      {"scan: {topic: lidar}\n", "/lidar: nobody publishes it as sensor_msgs/msg/LaserScan", "/scan"},
      {"scan: {topic: picture}\n", "/picture: is a sensor_msgs/msg/Image", "not a sensor_msgs/msg/LaserScan"},
      {"scan: {topic: quiet}\n", "/quiet: is published, but nothing readable", "XCDR1"},
      {"command: {topic: nowhere}\n", "/nowhere: nobody reads", "commands"},
      {"command: {topic: driven}\n", "another program sends commands on /driven",
       "does not drive beside it"}};
  const double last_motion_s = relay->last_motion_s();
  std::vector<std::string>
      connections;  // all are there before the first is read: they share a vehicle's file
  for (const auto& [keys, what, more] : refusals)
    connections.push_back(connection(what.substr(1, 4) + ".yaml", keys));
  std::vector<std::unique_ptr<RunningAisle>> started;
  for (const std::string& file : connections) started.push_back(exploring(file));
  for (std::size_t i = 0; i < refusals.size(); ++i) {
    const ProgramRun run = started[i]->wait();
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_THAT(run.err, AllOf(HasSubstr(refusals[i][1]), HasSubstr(refusals[i][2])));
  }
  EXPECT_EQ(relay->last_motion_s(), last_motion_s);
}

}  // namespace
}  // namespace aisle
