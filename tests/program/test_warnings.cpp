#include <gmock/gmock.h>

#include <sstream>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kBeams = 180;
constexpr std::size_t kFirstReading = 2;
constexpr std::size_t kLaserPose = kFirstReading + kBeams;
constexpr std::size_t kRobotPose = kLaserPose + 3;
constexpr std::size_t kStamp = kRobotPose + 3;

std::vector<std::string> fields_of(const std::string& line) {
  std::istringstream text(line);
  std::vector<std::string> fields;
  for (std::string field; text >> field;) fields.push_back(field);
  return fields;
}

std::string hundredfold(const std::string& metres) {
  std::ostringstream text;
  text.precision(17);
  text << 100 * std::stod(metres);
  return text.str();
}

bool is_length_of_scan(std::size_t field) {
  const bool reading = field >= kFirstReading && field < kLaserPose;
  return reading || field == kLaserPose || field == kLaserPose + 1 || field == kRobotPose ||
         field == kRobotPose + 1;
}

std::string in_centimetres(const std::string& line) {
  std::vector<std::string> fields = fields_of(line);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool maximum = i == 2 && fields[1] == "robot_front_laser_max";
    if (maximum || (fields[0] == "FLASER" && is_length_of_scan(i))) fields[i] = hundredfold(fields[i]);
  }
  std::string joined;
  for (const std::string& field : fields) joined += field + " ";
  return joined;
}

class Warnings : public WorkplaceWithLog {
 protected:
  std::string log_in_centimetres() const {
    std::vector<std::string> lines = log_lines();
    for (std::string& line : lines) line = in_centimetres(line);
    return log_of("centimetres.log", lines);
  }

  /// From the five hundredth scan on, the clock is an hour behind.
  std::string log_with_clock_set_back() const {
    std::vector<std::string> lines = log_lines();
    const std::vector<std::size_t> scans = scan_lines(lines);
    for (std::size_t i = 500; i < scans.size(); ++i) {
      std::string& line = lines[scans[i]];
      line = with_field(line, kStamp, std::to_string(std::stod(fields_of(line)[kStamp]) - 3600));
    }
    return log_of("set-back.log", lines);
  }
};

TEST_F(Warnings, CentimetresReadAsMetresAreNoticed) {
  const ProgramRun run = run_aisle({"map", log_in_centimetres(), "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("warning: "));
  EXPECT_THAT(run.err, HasSubstr("--units cm"));
  EXPECT_EQ(run.json()["figures"]["trust"], "unknown");
}

TEST_F(Warnings, MetresReadAsCentimetresAreNoticed) {
  EXPECT_THAT(run_aisle({"map", log(), "--units", "cm"}).err, HasSubstr("--units cm"));
}

TEST_F(Warnings, CentimetresReadAsSuchGiveTheMapOfTheLogInMetres) {
  const ProgramRun in_cm =
      run_aisle({"map", log_in_centimetres(), "--units", "cm", "--relations", relations(), "--json"});
  EXPECT_THAT(in_cm.err, IsEmpty());
  const auto cm = in_cm.json()["figures"];
  const auto m = run_aisle({"map", log(), "--relations", relations(), "--json"}).json()["figures"];
  EXPECT_NEAR(cm["path_m"].get<double>(), m["path_m"].get<double>(), 0.02);
  EXPECT_NEAR(cm["walls"].get<int>(), m["walls"].get<int>(), 1);
  EXPECT_NEAR(cm["translation_m"]["mean"].get<double>(), m["translation_m"]["mean"].get<double>(), 1e-3);
}

TEST_F(Warnings, StampsThatGoBackAreNoticedAndDoNoHarm) {
  const ProgramRun run = run_aisle({"map", log_with_clock_set_back(), "--relations", relations(), "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("warning: "));
  EXPECT_THAT(run.err, HasSubstr("stamps go back"));
  EXPECT_LT(run.json()["figures"]["translation_m"]["mean"], 0.03);
}

TEST_F(Warnings, QuietSilencesThem) {
  const ProgramRun run = run_aisle({"map", log_with_clock_set_back(), "--quiet", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, IsEmpty());
}

TEST_F(Warnings, AGoodLogGivesNone) {
  EXPECT_THAT(run_aisle({"map", log()}).err, IsEmpty());
}

}  // namespace
}  // namespace aisle
