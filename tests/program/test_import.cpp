#include <chrono>
#include <csignal>
#include <thread>

#include "aisle/formats/images/image_file.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/ros_messages.hpp"
#include "aisle/formats/sessions/session_writer.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::string jpeg(int width_px, int height_px, int seed) {
  Image image(width_px, height_px);
  for (std::size_t i = 0; i < image.bytes.size(); ++i)
    image.bytes[i] = static_cast<std::uint8_t>(i * 7 / 5 + static_cast<std::size_t>(seed) * 31);
  return jpeg_bytes(image, 90);
}

class Import : public Workplace {
 protected:
  /// A tub of ten images, 100 ms apart, with a line of NUL bytes in its catalog.
  std::string tub(int images = 10) {
    fs::create_directories(at("tub/images"));
    file("tub/manifest.json",
         "[\"cam/image_array\", \"user/angle\", \"user/throttle\"]\n[\"image_array\", \"float\", "
         "\"float\"]\n{}\n"
         "{}\n{\"paths\": [\"catalog_0.catalog\"], \"deleted_indexes\": []}\n");
    std::string catalog(50, '\0');
    for (int i = 0; i < images; ++i) {
      catalog += "\n{\"_index\": " + std::to_string(i) +
                 ", \"_timestamp_ms\": " + std::to_string(1626922343713 + 100L * i) +
                 ", \"cam/image_array\": \"" + std::to_string(i) +
                 ".jpg\", \"user/angle\": 0.5, \"user/throttle\": 0.3}";
      file("tub/images/" + std::to_string(i) + ".jpg", jpeg(320, 240, i));
    }
    file("tub/catalog_0.catalog", catalog);
    return at("tub");
  }

  /// Images of the mini-vehicle's size with their list of poses.
  std::string list() {
    fs::create_directories(at("images"));
    std::string rows = "stamp_s,file,x_m,y_m,heading_deg\n";
    for (int i = 0; i < 10; ++i) {
      rows += std::to_string(i) + "," + std::to_string(i) + ".jpg," + std::to_string(0.1 * i) + ",0,0\n";
      file("images/" + std::to_string(i) + ".jpg", jpeg(320, 240, i));
    }
    return file("images/list.csv", rows);
  }
};

TEST_F(Import, ATubBecomesASession) {
  const ProgramRun run = run_aisle({"import", tub(), "--out", at("drive"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["images"], 10);
  EXPECT_NEAR(figures["duration_s"], 0.9, 1e-6);
  EXPECT_NEAR(figures["rate_hz"], 10, 1e-6);
  EXPECT_EQ(figures["left_out"], 1);
  EXPECT_EQ(figures["odometry"], false);
  EXPECT_EQ(run.json()["files"]["session"], at("drive"));
  EXPECT_THAT(run.err, AllOf(HasSubstr("catalog_0.catalog:1: is a line of NUL bytes"),
                             HasSubstr("has no odometry"), HasSubstr("lens and mount")));
  const auto origin = run_aisle({"info", at("drive"), "--json"}).json()["figures"]["origin"];
  EXPECT_EQ(origin["navigator"], "imported");
  EXPECT_EQ(origin["simulated"], false);
  EXPECT_THAT(run_aisle({"info", at("drive")}).out, HasSubstr("imported, without odometry"));
}

/// A robot's bag: ten images of each camera, odometry, and the lens of the first camera.
void write_bag(const fs::path& directory, const std::vector<std::string>& cameras) {
  auto bag = SessionWriter::create(directory, false);
  const auto write = [&](const std::string& topic, double stamp_s, const auto& message) {
    using Message = std::remove_cvref_t<decltype(message)>;
    ASSERT_THAT(bag->write({topic, Message::kType}, ros::stamp_ns(stamp_s), cdr_bytes(message)),
                testing::IsEmpty());
  };
  ros::CameraInfo info;
  info.width = 320, info.height = 240;
  info.distortion_model = "equidistant";
  info.d = {0.1, 0, 0, 0.01};
  info.k = {200, 0, 160, 0, 200, 120, 0, 0, 1};
  for (int i = 0; i < 10; ++i) {
    const double stamp_s = 1000 + 0.1 * i;
    ros::Header header{ros::time_of(ros::stamp_ns(stamp_s)), "camera"};
    ros::Odometry odometry{{header.stamp, "odom"}, "base_link", {}, {}};
    odometry.pose.pose.position.x = 0.1 * i;
    write("/odom", stamp_s, odometry);
    write(cameras.front() + "/camera_info", stamp_s, info);
    for (const std::string& camera : cameras) {
      const std::string bytes = jpeg(320, 240, i);
      write(camera + "/image_raw/compressed", stamp_s,
            ros::CompressedImage{header, "jpeg", {bytes.begin(), bytes.end()}});
    }
  }
  ASSERT_THAT(bag->close(), testing::IsEmpty());
}

TEST_F(Import, ABagWithACameraBecomesASession) {
  write_bag(at("bag"), {"/front"});
  EXPECT_THAT(run_aisle({"info", at("bag")}).out, HasSubstr("`aisle import` makes a session of it"));
  const ProgramRun run = run_aisle({"import", at("bag"), "--out", at("drive"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["images"], 10);
  EXPECT_EQ(figures["odometry"], true);
  EXPECT_EQ(figures["calibration"], false);
  EXPECT_THAT(run.err, HasSubstr("tells nothing of the camera's mount; --vehicle"));
  const ProgramRun posed = run_aisle(
      {"import", at("bag"), "--vehicle", "mini", "--odometry", "none", "--out", at("posed"), "--json"});
  ASSERT_EQ(posed.exit_code, 0) << posed.err;
  EXPECT_EQ(posed.json()["figures"]["odometry"], false);
  EXPECT_THAT(posed.err, HasSubstr("another calibration than the camera of --vehicle"));
}

TEST_F(Import, OfABagWithSeveralCamerasTheUserNamesOne) {
  write_bag(at("bag"), {"/front", "/rear"});
  EXPECT_THAT(run_aisle({"import", at("bag"), "--out", at("drive"), "--json"}),
              IsRefused("has images on 2 topics, /front/image_raw/compressed (10), "
                        "/rear/image_raw/compressed (10): --camera TOPIC"));
  const ProgramRun run = run_aisle(
      {"import", at("bag"), "--camera", "/rear/image_raw/compressed", "--out", at("drive"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("lens and mount"));
  EXPECT_THAT(run_aisle({"import", at("bag"), "--camera", "/front/image_raw/compressed", "--vehicle", "alv",
                         "--out", at("other"), "--json"}),
              IsRefused("which took the images of /front/image_raw/compressed is not said by its name"));
}

/// A CARMEN log of a vehicle that drives past a wall.
std::string carmen_log() {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    const std::string x_m = std::to_string(0.1 * i), time_s = std::to_string(0.2 * i);
    text += "FLASER 181";
    for (int beam = 0; beam < 181; ++beam) text += " " + std::to_string(2 + 0.01 * beam);
    text += " " + x_m + " 0 0 " + x_m + " 0 0 " + time_s + " robot " + time_s + "\n";
  }
  return text;
}

TEST_F(Import, ALaserLogBecomesASession) {
  const std::string log = file("run.log", carmen_log());
  const ProgramRun run = run_aisle({"import", log, "--out", at("drive"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["scans"], 20);
  EXPECT_EQ(figures["images"], 0);
  EXPECT_EQ(figures["odometry"], true);
  EXPECT_FALSE(figures.contains("camera"));
  const ProgramRun cut = run_aisle({"cut", at("drive"), "--to", "1", "--out", at("part"), "--json"});
  ASSERT_EQ(cut.exit_code, 0) << cut.err;
  EXPECT_THAT(run_aisle({"info", at("part")}).out, HasSubstr("/scan"));
  EXPECT_THAT(run_aisle({"replay", at("drive"), "--navigator", "hand", "--json"}),
              IsRefused("nothing of its scanner's place"));
  ASSERT_EQ(run_aisle({"import", log, "--laser-offset", "0.1", "--out", at("placed")}).exit_code, 0);
  EXPECT_EQ(run_aisle({"replay", at("placed"), "--navigator", "hand"}).exit_code, 0);
  EXPECT_THAT(run_aisle({"learn", at("placed"), "--json"}), IsRefused("without a camera"));
  EXPECT_THAT(run_aisle({"import", log, "--image-rate", "5", "--out", at("other"), "--json"}),
              IsRefused("--image-rate"));
  EXPECT_THAT(run_aisle({"import", log, "--vehicle", "mini", "--out", at("other"), "--json"}),
              IsRefused("scanner: is missing"));
  EXPECT_EQ(run_aisle({"import", log, "--vehicle", "alv-scanner", "--out", at("other")}).exit_code, 0);
}

TEST_F(Import, IsNamedByVerbsThatAreGivenARecording) {
  const std::string log = file("run.log", carmen_log());
  write_bag(at("bag"), {"/front"});
  for (const std::string& recording : {log, at("bag"), at("bag/bag_0.db3")}) {
    EXPECT_THAT(run_aisle({"learn", recording, "--json"}), IsRefused("`aisle import`"));
    EXPECT_THAT(run_aisle({"replay", recording, "--json"}), IsRefused("`aisle import`"));
    if (recording != at("bag")) {
      EXPECT_THAT(run_aisle({"cut", recording, "--out", at("part"), "--json"}), IsRefused("`aisle import`"));
    }
  }
}

TEST_F(Import, WhatASessionLacksIsSaidByTheVerbsThatNeedIt) {
  ASSERT_EQ(run_aisle({"import", tub(), "--out", at("drive")}).exit_code, 0);
  for (const char* method : {"landmarks", "sections", "rooms"})
    EXPECT_THAT(run_aisle({"learn", at("drive"), "--method", method, "--json"}),
                IsRefused("has no odometry"));
  EXPECT_THAT(run_aisle({"replay", at("drive"), "--json"}), IsRefused("no decisions to compare with"));
  EXPECT_THAT(run_aisle({"replay", at("drive"), "--navigator", "hand", "--json"}),
              IsRefused("has no odometry"));
  const ProgramRun cut = run_aisle({"cut", at("drive"), "--to", "0.35", "--out", at("part"), "--json"});
  ASSERT_EQ(cut.exit_code, 0) << cut.err;
  EXPECT_EQ(run_aisle({"info", at("part"), "--json"}).json()["figures"]["origin"]["odometry"], false);
}

TEST_F(Import, AListWithPosesAndAVehicleHasAll) {
  const ProgramRun run = run_aisle({"import", list(), "--vehicle", "mini", "--out", at("drive"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.json()["figures"]["odometry"], true);
  EXPECT_EQ(run.json()["figures"]["calibration"], true);
  const ProgramRun replay = run_aisle({"replay", at("drive"), "--navigator", "hand", "--json"});
  ASSERT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_EQ(replay.json()["figures"]["compared"], 0);
}

TEST_F(Import, WithoutAVehicleNothingIsLearnedFromImages) {
  ASSERT_EQ(run_aisle({"import", list(), "--out", at("drive")}).exit_code, 0);
  EXPECT_THAT(run_aisle({"learn", at("drive"), "--json"}), IsRefused("import it with --vehicle"));
}

TEST_F(Import, RefusalsAreOneLineAndLeaveNothing) {
  EXPECT_THAT(run_aisle({"import", at("nowhere"), "--out", at("drive"), "--json"}),
              IsRefused("no such file"));
  EXPECT_THAT(run_aisle({"import", tub(), "--vehicle", "alv", "--out", at("drive"), "--json"}),
              IsRefused("camera"));
  fs::remove(at("tub/manifest.json"));
  fs::remove(at("tub/catalog_0.catalog"));
  EXPECT_THAT(run_aisle({"import", at("tub/images"), "--out", at("drive"), "--json"}),
              IsRefused("--image-rate HZ"));
  EXPECT_THAT(run_aisle({"import", at("tub/images"), "--image-rate", "0", "--out", at("drive"), "--json"}),
              IsRefused("--image-rate"));
  EXPECT_FALSE(fs::exists(at("drive")));
  ASSERT_EQ(run_aisle({"import", at("tub/images"), "--image-rate", "5", "--out", at("drive")}).exit_code, 0);
  EXPECT_THAT(run_aisle({"import", at("tub/images"), "--image-rate", "5", "--out", at("drive"), "--json"}),
              IsRefused("--force"));
}

TEST_F(Import, KilledItLeavesNoHalfSession) {
  RunningAisle importing({"import", tub(400), "--out", at("drive"), "--json"});
  const auto has_begun = [&] {
    return fs::exists(at(".drive.importing/drive/drive_0.db3")) || fs::exists(at("drive/metadata.yaml"));
  };
  for (int i = 0; i < 10'000 && !has_begun(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  importing.signal(SIGKILL);
  importing.wait();
  if (!fs::exists(at("drive/metadata.yaml"))) {
    EXPECT_THAT(run_aisle({"info", at("drive"), "--json"}), IsRefused("is not a session"));
  }
  ASSERT_EQ(run_aisle({"import", at("tub"), "--out", at("drive"), "--force", "--json"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(at(".drive.importing")));
}

}  // namespace
}  // namespace aisle
