#include <bzlib.h>
#include <gmock/gmock.h>
#include <zlib.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "aisle/formats/logs/read_laser_recording.hpp"
#include "logs/carmen_lines.hpp"
#include "logs/mrpt_bytes.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

class ReadLaserRecording : public testing::Test {
 protected:
  ReadLaserRecording()
      : folder_(fs::path(testing::TempDir()) /
                (std::string("recording-") + testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~ReadLaserRecording() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  std::string refusal(const fs::path& path) const {
    const auto recording = read_laser_recording(path);
    return recording.ok() ? "" : to_string(recording.problems());
  }

  fs::path folder_;
};

std::string gzipped(const fs::path& scratch, const std::string& text) {
  const gzFile packed = gzopen(scratch.c_str(), "wb");
  gzwrite(packed, text.data(), static_cast<unsigned>(text.size()));
  gzclose(packed);
  std::ifstream in(scratch, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  fs::remove(scratch);
  return bytes;
}

std::string bzipped(std::string text) {
  std::string packed(text.size() + 1000, '\0');
  auto size = static_cast<unsigned>(packed.size());
  BZ2_bzBuffToBuffCompress(packed.data(), &size, text.data(), static_cast<unsigned>(text.size()), 1, 0, 0);
  packed.resize(size);
  return packed;
}

std::string long_log() {
  std::string text;
  for (int i = 0; i < 2000; ++i)
    text += flaser(0.1 * i, std::to_string(1 + i % 7) + " 2 " + std::to_string(i % 90));
  return text;
}

TEST_F(ReadLaserRecording, TellsTheKindByContentWhateverTheName) {
  const std::string carmen = flaser(1) + flaser(2);
  for (const std::string& bytes :
       {carmen, gzipped(folder_ / "scratch", carmen), bzipped(carmen), mrpt_scan({}) + mrpt_scan({}),
        gzipped(folder_ / "scratch", mrpt_scan({}) + mrpt_scan({})),
        std::string(
            "# first_angle_deg: 0\n# angle_step_deg: 1\ntime_s,range_0_m,range_1_m\n1,2,3\n2,2,3\n")}) {
    const auto recording = read_laser_recording(file("picture.png", bytes));
    ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
    EXPECT_THAT(recording->log.scans, SizeIs(2));
  }
}

TEST_F(ReadLaserRecording, OfAPackedFileThatIsCutOffTheWholeLinesAreUsed) {
  const std::string text = long_log();
  const std::string gzip = gzipped(folder_ / "scratch", text);
  const auto cut = read_laser_recording(file("cut.gz", gzip.substr(0, gzip.size() / 2)));
  ASSERT_TRUE(cut.ok()) << to_string(cut.problems());
  EXPECT_GT(cut->log.scans.size(), 100U);
  EXPECT_LT(cut->log.scans.size(), 2000U);
  EXPECT_THAT(warnings_of(*cut), HasSubstr("the gzip stream is cut off; what comes before is used"));
  const auto twice = read_laser_recording(file("twice.bz2", bzipped(text) + bzipped(text)));
  ASSERT_TRUE(twice.ok()) << to_string(twice.problems());
  EXPECT_THAT(twice->log.scans, SizeIs(4000));
}

TEST_F(ReadLaserRecording, AFolderWithOneRecordingIsThatRecording) {
  file("README.md", "# About it\n");
  file("run.log", flaser(1));
  const auto recording = read_laser_recording(folder_);
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_THAT(recording->log.scans, SizeIs(1));
  file("second.log", flaser(1));
  EXPECT_THAT(refusal(folder_), HasSubstr("is a folder of 2 recordings: name one of them"));
}

TEST_F(ReadLaserRecording, AnythingElseIsRefusedInOneLineThatSaysWhatItLooksLike) {
  const auto looks_like = [&](const std::string& bytes, const char* what) {
    const std::string problem = refusal(file("what", bytes));
    EXPECT_THAT(problem, HasSubstr(std::string("is ") + what));
    EXPECT_THAT(problem, HasSubstr("recordings are CARMEN logs, MRPT rawlogs, CSV"));
    EXPECT_THAT(problem, Not(HasSubstr("\n")));
  };
  looks_like("", "empty");
  looks_like("\x89PNG\r\n\x1a\n", "a PNG image");
  looks_like("PK\x03\x04zip", "a zip archive; unpack it first");
  looks_like("<!DOCTYPE html>\n<html>", "a web page");
  looks_like("# .PCD v0.7\nVERSION 0.7\n", "a point cloud");
  looks_like("{\"a\": 1}", "a JSON file");
  looks_like("distance,angle\n1,2\n", "a table, but its header does not name");
  looks_like("Dear reader\n", "a text of another kind, beginning 'Dear reader'");
  looks_like(std::string("\x01\x02\x00\x03", 4), "binary data");
  std::string tar(600, '\0');
  tar.replace(0, 7, "run.log");
  tar.replace(257, 5, "ustar");
  looks_like(tar, "a tar archive; unpack it first");
  looks_like(gzipped(folder_ / "scratch", tar + flaser(1)), "a tar archive; unpack it first");
  EXPECT_THAT(refusal(folder_ / "nothing"), HasSubstr("no such file"));
  fs::remove(folder_ / "what");
  EXPECT_THAT(refusal(folder_), HasSubstr("is a folder without a recording"));
}

}  // namespace
}  // namespace aisle
