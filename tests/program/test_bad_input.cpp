#include <gmock/gmock.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;

/// What is whole is used: exit code 0, and a warning that contains `what`.
MATCHER_P(IsUsedWithWarning, what, std::string("is used, with a warning that says '") + what + "'") {
  *result_listener << "exit code " << arg.exit_code << ", stderr: " << arg.err;
  return arg.exit_code == 0 && arg.err.find("warning: ") != std::string::npos &&
         arg.err.find(what) != std::string::npos;
}

class BadInput : public WorkplaceWithLog {
 protected:
  /// Maps `log`; whatever the outcome, nothing may be left behind.
  ProgramRun map(const std::string& log, const Arguments& options = {}) const {
    Arguments arguments = {"map", log, "--out", at("out"), "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = run_aisle(arguments);
    EXPECT_THAT(names_in(at("out")), IsEmpty());
    return run;
  }

  /// Maps the log with the line of its hundredth scan changed; the program should warn of `place_`.
  ProgramRun map_with_bad_scan(const std::function<std::string(std::string)>& change) {
    std::vector<std::string> lines = log_lines();
    const std::size_t bad = scan_lines(lines).at(99);
    lines[bad] = change(lines[bad]);
    place_ = at("bad.log") + ":" + std::to_string(bad + 1) + ": ";
    return run_aisle({"map", log_of("bad.log", lines), "--json"});
  }

  std::string place_;
};

TEST_F(BadInput, AMissingLogIsRefused) {
  EXPECT_THAT(map(at("none.log")), IsRefused(at("none.log") + ": no such file"));
}

TEST_F(BadInput, AFolderWithoutARecordingIsRefused) {
  std::filesystem::create_directory(at("empty"));
  EXPECT_THAT(map(at("empty")), IsRefused(at("empty") + ": is a folder without a recording"));
}

TEST_F(BadInput, AFolderWithOneRecordingIsThatRecording) {
  const auto figures = [](const std::string& log) {
    auto all = run_aisle({"map", log, "--json"}).json()["figures"];
    for (const char* measured : {"cpu_s", "realtime_factor", "peak_rss_mb"}) all.erase(measured);
    return all;
  };
  EXPECT_EQ(figures(at("sim")), figures(log()));
}

TEST_F(BadInput, AnEmptyLogIsRefused) {
  EXPECT_THAT(map(file("empty.log", "")), IsRefused(at("empty.log") + ": is empty"));
}

TEST_F(BadInput, BinaryDataIsRefused) {
  std::string bytes;
  for (int i = 0; i < 10000; ++i) bytes += static_cast<char>((i * i) % 251);
  EXPECT_THAT(map(file("binary.log", bytes)), IsRefused("is binary data"));
}

TEST_F(BadInput, APictureOfAMapIsRefused) {
  ASSERT_EQ(run_aisle({"map", log(), "--out", at("before")}).exit_code, 0);
  EXPECT_THAT(map(at("before/map.png")), IsRefused(at("before/map.png")));
}

TEST_F(BadInput, TextThatIsNoLogIsRefused) {
  EXPECT_THAT(map(file("letter.txt", "Dear reader,\nthis is no log.\n")),
              IsRefused("is a text of another kind"));
}

TEST_F(BadInput, ALogWithoutScansIsRefused) {
  EXPECT_THAT(map(file("none.log", "PARAM robot_front_laser_max 50\nODOM 0 0 0 0 0 0 1 robot 1\n")),
              IsRefused("has no scans"));
}

TEST_F(BadInput, OfALogThatIsCutOffTheWholeLinesAreUsed) {
  const std::string text = read_bytes(log());
  const std::string most = text.substr(0, text.find(' ', text.size() * 9 / 10));
  const auto line = 1 + std::count(most.begin(), most.end(), '\n');
  EXPECT_THAT(run_aisle({"map", file("cut.log", most), "--json"}),
              IsUsedWithWarning(at("cut.log") + ":" + std::to_string(line) + ": "));
}

TEST_F(BadInput, OfAGzipStreamThatIsCutOffTheWholeLinesAreUsed) {
  const std::string text = read_bytes(log());
  const gzFile packed = gzopen(at("simulated-trip.log.gz").c_str(), "wb");
  gzwrite(packed, text.data(), static_cast<unsigned>(text.size()));
  gzclose(packed);
  ASSERT_EQ(run_aisle({"map", at("simulated-trip.log.gz")}).exit_code, 0);
  const std::string bytes = read_bytes(at("simulated-trip.log.gz"));
  EXPECT_THAT(run_aisle({"map", file("cut.gz", bytes.substr(0, bytes.size() * 9 / 10)), "--json"}),
              IsUsedWithWarning("gzip stream is cut off"));
}

TEST_F(BadInput, AScanWithFewerBeamsThanTheOthersIsTakenByItsOwn) {
  const ProgramRun run = map_with_bad_scan([](const std::string& line) {
    return "FLASER 179" + line.substr(line.find(' ', line.find(' ', line.find(' ') + 1) + 1));
  });
  EXPECT_THAT(run, IsUsedWithWarning(place_ + "1 scans have other numbers of readings"));
}

TEST_F(BadInput, AScanThatAnnouncesMoreBeamsThanItHasIsLeftOut) {
  EXPECT_THAT(map_with_bad_scan([](const std::string& line) { return with_field(line, 1, "9000"); }),
              IsUsedWithWarning(place_));
}

TEST_F(BadInput, ReadingsThatAreNoDistancesAreCounted) {
  for (const char* reading : {"nan", "-nan", "-inf", "-1.5", "1e300"}) {
    EXPECT_THAT(map_with_bad_scan([&](const std::string& line) { return with_field(line, 50, reading); }),
                IsUsedWithWarning(place_ + "1 readings"))
        << reading;
  }
}

TEST_F(BadInput, AbsurdNumbersAreLeftOutWithTheirLine) {
  for (const std::size_t field : {1, 185, 188}) {
    EXPECT_THAT(map_with_bad_scan([&](const std::string& line) { return with_field(line, field, "1e300"); }),
                IsUsedWithWarning(place_ + "field " + std::to_string(field + 1)));
  }
}

TEST_F(BadInput, WordsInPlaceOfNumbersAreLeftOutWithTheirLine) {
  for (const std::size_t field : {1, 50, 188}) {
    EXPECT_THAT(map_with_bad_scan([&](const std::string& line) { return with_field(line, field, "wall"); }),
                IsUsedWithWarning(place_ + "field " + std::to_string(field + 1)));
  }
}

TEST_F(BadInput, RelationsThatNameUnknownScansAreRefused) {
  const std::string by_number = file("by-number", "# i1 i2 x y yaw\n0 5000 1 0 0\n");
  EXPECT_THAT(map(log(), {"--relations", by_number}), IsRefused(by_number + ":2: the log has no scan 5000"));
  const std::string by_stamp = file("by-stamp", "0.2 777.7 1 0 0 0 0 0\n");
  EXPECT_THAT(map(log(), {"--relations", by_stamp}), IsRefused(by_stamp + ":1: "));
}

TEST_F(BadInput, RelationsThatAreNoneAreRefused) {
  EXPECT_THAT(map(log(), {"--relations", at("none")}), IsRefused("no such file"));
  EXPECT_THAT(map(log(), {"--relations", file("empty", "")}), IsRefused(at("empty")));
  EXPECT_THAT(map(log(), {"--relations", file("letter", "Dear reader\n")}), IsRefused(at("letter") + ":1: "));
}

TEST_F(BadInput, LaserOffsetsThatAreNoPlaceOnAVehicleAreRefused) {
  for (const char* offset : {"", "front", "1,2,3,4", "1,", "nan", "inf", "1e9"}) {
    EXPECT_THAT(map(log(), {"--laser-offset", offset}), IsRefused("--laser-offset")) << offset;
  }
}

TEST_F(BadInput, OdometryDelaysThatAreNoneAreRefused) {
  for (const char* delay : {"soon", "nan", "1000"}) {
    EXPECT_THAT(map(log(), {"--odometry-delay", delay}), IsRefused("--odometry-delay")) << delay;
  }
}

TEST_F(BadInput, UnknownUnitsAndRulesAreRefused) {
  EXPECT_THAT(map(log(), {"--units", "furlong"}), IsRefused("furlong"));
  EXPECT_THAT(map(log(), {"--rules", "golden"}), IsRefused("golden"));
}

TEST_F(BadInput, WorldsThatAreNoneAreRefused) {
  for (const std::string& world : {at("none.yaml"), at("sim"), log(), file("empty.yaml", "")}) {
    EXPECT_THAT(run_aisle({"sim", "log", world, "--out", at("out"), "--json"}), IsRefused(world));
  }
}

TEST_F(BadInput, SimulatedScannersThatTheLogCannotExpressAreRefused) {
  EXPECT_THAT(run_aisle({"sim", "log", AISLE_SOURCE_DIR "/worlds/small-office.yaml", "--set",
                         "scanner.beams=100", "--out", at("out"), "--json"}),
              IsRefused("scanner"));
  EXPECT_THAT(names_in(at("out")), IsEmpty());
}

}  // namespace
}  // namespace aisle
