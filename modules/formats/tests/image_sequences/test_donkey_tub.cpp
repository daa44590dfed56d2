#include <gmock/gmock.h>

#include "image_sequences/recordings.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class DonkeyTub : public testing::Test {
 protected:
  void SetUp() override {
    write_tub_images(tub, 10);
    write_file(tub / "manifest.json", tub_manifest());
    write_catalog();
  }

  /// A catalog of ten lines, some of them replaced.
  void write_catalog(const std::map<int, std::string>& replaced = {}) {
    std::string text;
    for (int i = 0; i < 10; ++i) {
      const auto other = replaced.find(i);
      text += other == replaced.end() ? catalog_line(i) : other->second;
    }
    write_file(tub / "catalog_0.catalog", text);
  }

  std::unique_ptr<ImageSequence> open(const ImageSequenceOptions& options = {}) {
    auto sequence = open_image_sequence(tub.string(), options);
    EXPECT_TRUE(sequence.ok()) << to_string(sequence.problems());
    return std::move(sequence).value();
  }

  std::string refusal(const ImageSequenceOptions& options = {}) {
    const auto sequence = open_image_sequence(tub.string(), options);
    return sequence.ok() ? "" : to_string(sequence.problems());
  }

  SessionPlace place;
  std::filesystem::path tub = place / "tub";
};

TEST_F(DonkeyTub, GivesImagesByteForByteWithStampsAndControls) {
  const auto sequence = open();
  EXPECT_EQ(sequence->width_px(), 32);
  EXPECT_EQ(sequence->height_px(), 24);
  EXPECT_EQ(sequence->size(), 10U);
  EXPECT_FALSE(sequence->has_odometry());
  EXPECT_NEAR(sequence->period_s(), 0.05, 1e-6);
  const auto images = read_all(*sequence);
  ASSERT_THAT(images, SizeIs(10));
  EXPECT_EQ(images[3].bytes, sample_jpeg(3));
  EXPECT_NEAR(images[3].stamp_s, 1626922343.863, 1e-6);
  EXPECT_EQ(images[3].controls->steering, -0.25);
  EXPECT_EQ(images[3].controls->throttle, 0.7);
  EXPECT_FALSE(images[3].T_odom_vehicle);
  EXPECT_EQ(sequence->left_out(), 0U);
  ASSERT_THAT(sequence->warnings(), SizeIs(1));
  EXPECT_THAT(sequence->warnings()[0].what, HasSubstr("no odometry"));
}

TEST_F(DonkeyTub, LeavesOutDamagedLinesWithOneWarning) {
  write_catalog({{4, std::string(300, '\0') + "\n"}, {6, catalog_line(6).substr(0, 40) + catalog_line(6)}});
  const auto sequence = open();
  EXPECT_THAT(read_all(*sequence), SizeIs(8));
  EXPECT_EQ(sequence->left_out(), 2U);
  const Problems warnings = sequence->warnings();
  ASSERT_THAT(warnings, SizeIs(2));
  EXPECT_EQ(warnings[1].where.line, 5);
  EXPECT_THAT(warnings[1].what, AllOf(HasSubstr("NUL bytes"), HasSubstr("2 records are left out")));
}

TEST_F(DonkeyTub, LeavesOutWhatTheDriverDeleted) {
  write_file(tub / "manifest.json", tub_manifest("0, 1, 7"));
  const auto images = read_all(*open());
  ASSERT_THAT(images, SizeIs(7));
  EXPECT_EQ(images[0].bytes, sample_jpeg(2));
}

TEST_F(DonkeyTub, KeepsTheOrderOfIndexesWhereTheClockGoesBack) {
  write_catalog({{5, catalog_line(5, kTubStart_ms - 100'000)}});
  const auto sequence = open();
  const auto images = read_all(*sequence);
  ASSERT_THAT(images, SizeIs(10));
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(images[i].bytes, sample_jpeg(static_cast<int>(i)));
  for (std::size_t i = 1; i < 10; ++i) EXPECT_GT(images[i].stamp_s, images[i - 1].stamp_s);
  EXPECT_NEAR(images[5].stamp_s - images[4].stamp_s, 0.05, 1e-5);
  EXPECT_THAT(to_string(sequence->warnings()), HasSubstr("no later stamp than the image before"));
}

TEST_F(DonkeyTub, CountsMissingDamagedAndOtherSizedImages) {
  std::filesystem::remove(tub / "images/2_cam_image_array_.jpg");
  std::filesystem::remove(tub / "images/3_cam_image_array_.jpg");
  write_file(tub / "images/4_cam_image_array_.jpg", sample_jpeg(4).substr(0, 200));
  write_file(tub / "images/5_cam_image_array_.jpg", sample_jpeg(5, 64, 48));
  const auto sequence = open();
  EXPECT_THAT(read_all(*sequence), SizeIs(6));
  EXPECT_EQ(sequence->left_out(), 4U);
  const std::string warnings = to_string(sequence->warnings());
  EXPECT_THAT(warnings, HasSubstr("2 missing images are left out"));
  EXPECT_THAT(warnings, HasSubstr("cut off after byte 200; 1 damaged image is left out"));
  EXPECT_THAT(warnings, HasSubstr("has 64 x 48 pixels, the first image 32 x 24"));
}

TEST_F(DonkeyTub, IgnoresWhatMacOsLeaves) {
  write_file(tub / "._catalog_0.catalog", "\x05\x16\x07");
  write_file(tub / "images/._1_cam_image_array_.jpg", "\x05\x16\x07");
  std::filesystem::remove(tub / "manifest.json");
  const auto sequence = open();
  EXPECT_THAT(read_all(*sequence), SizeIs(10));
  EXPECT_EQ(sequence->left_out(), 0U);
  EXPECT_THAT(to_string(sequence->warnings()), HasSubstr("all catalogs of the folder are read"));
}

TEST_F(DonkeyTub, SuspectsStampsThatNoCameraHas) {
  std::map<int, std::string> fast;
  for (int i = 0; i < 10; ++i) fast[i] = catalog_line(i, kTubStart_ms + 5L * i);
  write_catalog(fast);
  EXPECT_THAT(to_string(open()->warnings()), HasSubstr("stamps 5.0 ms apart"));
  const auto slow = open({.rate_hz = 20, .front_steered = {}});
  EXPECT_NEAR(slow->period_s(), 0.05, 1e-9);
  EXPECT_THAT(to_string(slow->warnings()), Not(HasSubstr("ms apart")));
  EXPECT_NEAR(read_all(*slow)[9].stamp_s, 0.45, 1e-9);
}

TEST_F(DonkeyTub, StampsThatStandStillNeedARate) {
  std::map<int, std::string> still;
  for (int i = 0; i < 10; ++i) still[i] = catalog_line(i, kTubStart_ms);
  write_catalog(still);
  EXPECT_THAT(refusal(), HasSubstr("--image-rate HZ"));
  EXPECT_THAT(refusal({.rate_hz = 10, .front_steered = {}}), IsEmpty());
}

TEST_F(DonkeyTub, ClocksBeyondAllTimesAreRefused) {
  write_catalog({{0, catalog_line(0, 2'000'000'000'000)}, {5, catalog_line(5, 2'000'000'000'000)}});
  EXPECT_THAT(refusal(), HasSubstr("make no sense"));
}

TEST_F(DonkeyTub, WithoutAUsableImageItIsRefused) {
  std::filesystem::remove_all(tub / "images");
  EXPECT_THAT(refusal(), AllOf(HasSubstr("no such file"), HasSubstr("none of the images")));
  write_file(tub / "catalog_0.catalog", "");
  EXPECT_THAT(refusal(), HasSubstr("has no images"));
  std::filesystem::remove(tub / "catalog_0.catalog");
  EXPECT_THAT(refusal(), HasSubstr("has no images"));
  write_file(tub / "manifest.json", R"({"name": "my web page"})");
  EXPECT_THAT(refusal(), HasSubstr("not the manifest of a tub"));
}

TEST_F(DonkeyTub, APathInARecordStaysInTheTub) {
  write_file(place / "secret.jpg", sample_jpeg(99));
  write_catalog({{0, R"({"_index": 0, "_timestamp_ms": 5, "cam/image_array": "../../secret.jpg"})"
                     "\n"}});
  EXPECT_THAT(read_all(*open()), Not(Contains(Field(&TimedImage::bytes, sample_jpeg(99)))));
}

TEST_F(DonkeyTub, OldTubsHaveAFileARecord) {
  const std::filesystem::path old = place / "old";
  for (int i = 8; i < 12; ++i) {
    const std::string name = std::to_string(i) + "_cam-image_array_.jpg";
    write_file(old / name, sample_jpeg(i));
    write_file(old / ("record_" + std::to_string(i) + ".json"),
               R"({"cam/image_array": ")" + name +
                   R"(", "user/angle": 0.5, "user/throttle": 0.1, "milliseconds": )" +
                   std::to_string(100 * i) + "}");
  }
  const auto sequence = open_image_sequence(old.string());
  ASSERT_TRUE(sequence.ok()) << to_string(sequence.problems());
  const auto images = read_all(**sequence);
  ASSERT_THAT(images, SizeIs(4));
  EXPECT_EQ(images[2].bytes, sample_jpeg(10));
  EXPECT_NEAR(images[2].stamp_s, 1.0, 1e-9);
  EXPECT_EQ(images[2].controls->steering, 0.5);
}

TEST_F(DonkeyTub, ArchivesAreRefusedWithAdvice) {
  write_file(place / "tub.tar.gz", "x");
  const auto sequence = open_image_sequence((place / "tub.tar.gz").string());
  ASSERT_FALSE(sequence.ok());
  EXPECT_THAT(to_string(sequence.problems()), HasSubstr("unpack it"));
}

}  // namespace
}  // namespace aisle
