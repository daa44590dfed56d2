/// `aisle connect` and `--connect` where there is no robot.
#include <gmock/gmock.h>
#include <unistd.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class Connect : public Workplace {
 protected:
  /// A domain that no robot of another test is in: those have 20 and more.
  static std::string empty_domain() { return std::to_string(8 + getpid() % 8); }
};

TEST_F(Connect, AnEmptyNetworkHasNoTopics) {
  const ProgramRun run =
      run_aisle({"connect", "list", "--domain", empty_domain(), "--seconds", "0.5", "--json"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.json()["figures"]["topics"], IsEmpty());
}

TEST_F(Connect, ACheckNamesAllThatIsMissing) {
  const ProgramRun run = run_aisle({"connect", "check", "--domain", empty_domain(), "--seconds", "0.5"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("no scans"), HasSubstr("no odometry"), HasSubstr("reads commands")));
}

TEST_F(Connect, AnInterfaceThatIsNotOfThisMachineIsRefused) {
  const ProgramRun run = run_aisle({"connect", "list", "--interface", "192.0.2.1", "--seconds", "0.5"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("192.0.2.1"), HasSubstr("not an address of this machine"),
                             HasSubstr("127.0.0.1")));
}

TEST_F(Connect, InitAsksForWhatItCannotKnow) {
  const ProgramRun run = run_aisle({"connect", "init", "--out", at("robot.yaml")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("--footprint"), HasSubstr("--vehicle")));
  EXPECT_FALSE(std::filesystem::exists(at("robot.yaml")));
}

TEST_F(Connect, InitWritesNothingWhereThereIsNoRobot) {
  const ProgramRun run = run_aisle({"connect", "init", "--out", at("robot.yaml"), "--footprint",
                                    "0.2,0.2,0.3", "--domain", empty_domain(), "--seconds", "0.5"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(at("robot.yaml")));
  EXPECT_FALSE(std::filesystem::exists(at("robot-vehicle.yaml")));
}

TEST_F(Connect, InitRefusesMeasuresThatNoVehicleFileMayHave) {
  for (const char* size : {"0,0,0", "nan,0.2,0.3"}) {
    const ProgramRun run = run_aisle({"connect", "init", "--out", at("robot.yaml"), "--footprint", size});
    EXPECT_EQ(run.exit_code, 2) << size;
    EXPECT_THAT(run.err, HasSubstr("footprint.front_m")) << size;
    EXPECT_FALSE(std::filesystem::exists(at("robot.yaml")));
  }
}

TEST_F(Connect, AFileAndTheOptionsOfANetworkAreNotBoth) {
  const ProgramRun run = run_aisle({"connect", "list", "--connect", at("robot.yaml"), "--domain", "3"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("--connect"), HasSubstr("--domain")));
}

TEST_F(Connect, AConnectionFileThatIsWrongIsRefusedWithItsPlaces) {
  write_bytes(at("robot.yaml"), "format: aisle.connection\nversion: 1\nvehicle: mini\nclock: wall\n");
  const ProgramRun run = run_aisle({"explore", "--connect", at("robot.yaml"), "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("robot.yaml:4: clock: 'wall' is none of stamps, ros, arrival"));
}

TEST_F(Connect, AWorldAndARobotAreNotBoth) {
  const ProgramRun run = run_aisle({"explore", "l-corridor", "--connect", at("robot.yaml")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("--connect"));
}

}  // namespace
}  // namespace aisle
