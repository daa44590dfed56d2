#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

class Doctor : public Workplace {
 protected:
  /// Runs a program by a shell; its result is `said`.
  int run_by_shell(const std::string& command) const {
    const std::string all = "cd " + at("") + " && " + command + " doctor --json >" + at("said");
    const int status = std::system(all.c_str());  // NOLINT(concurrency-mt-unsafe): no threads here
    return WEXITSTATUS(status);
  }

  nlohmann::json said() const { return nlohmann::json::parse(read_bytes(at("said"))); }
};

nlohmann::json check_of(const nlohmann::json& result, const std::string& name) {
  for (const nlohmann::json& check : result["figures"]["checks"])
    if (check["name"] == name) return check;
  return {};
}

TEST_F(Doctor, FindsWhatComesWithTheProgramAndWhatTheMachineHas) {
  const ProgramRun run = run_aisle({"doctor", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(check_of(run.json(), "shipped files")["state"], "good");
  EXPECT_EQ(check_of(run.json(), "memory")["state"], "good");
  for (const char* name :
       {"processor", "live page", "current folder", "cameras", "clock", "ROS 2 network", "multicast"})
    EXPECT_FALSE(check_of(run.json(), name)["found"].get<std::string>().empty()) << name;
  EXPECT_THAT(run_aisle({"doctor"}).out, HasSubstr("worlds, "));
}

TEST_F(Doctor, SaysWhatToDoAboutAllThatIsNotGood) {
  for (const nlohmann::json& check : run_aisle({"doctor", "--json"}).json()["figures"]["checks"])
    EXPECT_TRUE(check["state"] == "good" || !check["advice"].get<std::string>().empty()) << check;
}

TEST_F(Doctor, FailsWhereTheProgramIsAwayFromItsFiles) {
  std::filesystem::copy_file(AISLE_PROGRAM, at("aisle"));
  EXPECT_EQ(run_by_shell("./aisle"), 1);
  EXPECT_EQ(said()["ok"], false);
  EXPECT_EQ(check_of(said(), "shipped files")["state"], "missing");
  EXPECT_THAT(check_of(said(), "shipped files")["found"], HasSubstr("0 worlds"));
}

TEST_F(Doctor, NamesADomainThatCannotBeJoined) {
  for (const char* domain : {"red", "-1", "102", "7.5"}) {
    EXPECT_EQ(run_by_shell(std::string("ROS_DOMAIN_ID=") + domain + " " AISLE_PROGRAM), 0);
    EXPECT_EQ(check_of(said(), "ROS 2 network")["state"], "limited") << domain;
  }
}

}  // namespace
}  // namespace aisle
