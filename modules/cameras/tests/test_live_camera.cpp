#include "aisle/cameras/live_camera.hpp"

#include <gmock/gmock.h>
#include <gst/gst.h>

#include "aisle/core/clock.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "image_folder_place.hpp"
#include "opened_camera.hpp"
#include "painted_image.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kTestImages =
    "videotestsrc is-live=true pattern=white ! video/x-raw,width=50,height=32,framerate=50/1";

TEST(LiveCamera, ShowsAFolderToItsEnd) {
  const ImageFolderPlace place;
  for (int number = 1; number <= 20; ++number)
    place.write(std::to_string(number) + ".png", png_bytes(painted_image(number)));
  const auto camera = opened({.folder = place.path(), .rate_hz = 500});
  std::size_t taken = 0;
  std::uint64_t last = 0;
  while (const auto image = camera->newest(kPatience)) {
    EXPECT_GT(image->number, last);
    EXPECT_EQ(*image->pixels, painted_image(static_cast<int>(image->number)));
    last = image->number;
    ++taken;
  }
  EXPECT_EQ(last, 20) << "the newest image is kept until it is taken";
  EXPECT_EQ(camera->counts().arrived, 20);
  EXPECT_EQ(camera->counts().dropped, 20 - taken);
  EXPECT_EQ(camera->state(), CameraState::kEnded);
  EXPECT_EQ(camera->problem(), place.path() + ": all 20 images were shown, 0 left out");
}

TEST(LiveCamera, ReturnsEachImageOnce) {
  const ImageFolderPlace place;
  place.write("1.png", png_bytes(painted_image(1)));
  const auto camera = opened({.folder = place.path()});
  EXPECT_TRUE(camera->newest(kPatience));
  EXPECT_FALSE(camera->newest(kPatience)) << "the end is not waited for";
}

TEST(LiveCamera, RunsAPipeline) {
  const auto camera = opened({.pipeline = kTestImages});
  const LiveImage image = next_image(*camera);
  EXPECT_EQ(image.pixels->width_px, 50);
  EXPECT_EQ(image.pixels->height_px, 32);
  EXPECT_EQ(image.pixels->channels, 1);
  EXPECT_THAT(image.pixels->bytes, testing::Each(235)) << "white of video";
  EXPECT_EQ(camera->state(), CameraState::kLive);
  EXPECT_EQ(camera->problem(), "");
}

TEST(LiveCamera, GivesColourIfAskedTo) {
  const auto camera =
      opened({.pipeline = "videotestsrc pattern=red ! video/x-raw,width=50,height=32", .is_colour = true});
  const LiveImage image = next_image(*camera);
  ASSERT_EQ(image.pixels->channels, 3);
  ASSERT_EQ(image.pixels->bytes.size(), 3U * 50 * 32);
  EXPECT_EQ(image.pixels->row(31)[3 * 49], 255);
  EXPECT_EQ(image.pixels->row(31)[3 * 49 + 1], 0);
}

TEST(LiveCamera, StampsAreThePastOnBothClocks) {
  const SteadyClock clock;
  const double begin_s = clock.now_s();
  const auto camera = opened({.pipeline = kTestImages, .exposure_offset_s = -5});
  double last_s = 0;
  for (int i = 0; i < 3; ++i) {
    const LiveImage image = next_image(*camera);
    EXPECT_GT(image.stamp_s, last_s);
    EXPECT_GT(image.stamp_s, begin_s - 5);
    EXPECT_LE(image.stamp_s, clock.now_s() - 5);
    const auto realtime = std::chrono::system_clock::now().time_since_epoch();
    EXPECT_LE(image.realtime_ns, std::chrono::nanoseconds(realtime).count() - 4'900'000'000);
    last_s = image.stamp_s;
  }
}

TEST(LiveCamera, RefusesImagesOfAnotherSizeThanAskedFor) {
  const auto camera = opened({.pipeline = kTestImages, .width_px = 640, .height_px = 480});
  EXPECT_TRUE(eventually_says(*camera, "has 50 x 32 pixels instead of 640 x 480"));
  EXPECT_EQ(camera->counts().arrived, 0);
  EXPECT_GT(camera->counts().refused, 0);
}

TEST(LiveCamera, OpensAgainWhatHasEnded) {
  const auto camera = opened(
      {.pipeline = "videotestsrc num-buffers=1 ! video/x-raw,width=50,height=32", .silent_max_s = 0.2});
  EXPECT_TRUE(eventually(*camera, [&] { return camera->counts().arrived > 2; }));
  EXPECT_GE(camera->counts().reopened, 2);
}

TEST(LiveCamera, ADeviceThatIsNotThereIsOneLine) {
  const std::string why = refusal({.device = "/dev/video987"});
  EXPECT_THAT(why, HasSubstr("/dev/video987: is no camera: "));
  EXPECT_THAT(why, Not(HasSubstr("\n")));
}

TEST(LiveCamera, ADeviceThatIsNoCameraIsSaid) {
  const auto camera = opened({.device = "/dev/null"});
  EXPECT_TRUE(eventually_says(*camera, "/dev/null"));
  EXPECT_EQ(camera->state(), CameraState::kReopening);
  EXPECT_THAT(camera->problem(), AllOf(EndsWith(": reopening"), Not(HasSubstr("\n"))));
}

TEST(LiveCamera, APipelineThatIsNoneIsOneLineWithTheReason) {
  for (const auto& [text, reason] : std::initializer_list<std::pair<const char*, const char*>>{
           {"videotestsrc !", "syntax error"},
           {"videotestsrc ! (", "syntax error"},
           {"videotestsrc patern=white", "no property \"patern\""},
           {"videotestsrc pattern=whyte", "to \"whyte\""},
           {"audiotestsrc", "could not link audiotestsrc0 to video"},
           {"avdec_nothing", "apt-get install gstreamer1.0-libav"},
           {"mycamerasrc", "aisle does not know"},
           {"   ", "syntax error"}}) {
    const std::string why = refusal({.pipeline = text});
    EXPECT_THAT(why, AllOf(HasSubstr(reason), Not(HasSubstr("\n")))) << text;
  }
}

TEST(LiveCamera, APasswordInAPipelineIsNotShown) {
  EXPECT_THAT(refusal({.pipeline = "souphttpsrc location=ftp://admin:secret@camera patern=1"}),
              AllOf(HasSubstr("patern"), Not(HasSubstr("secret"))));
  EXPECT_THAT(refusal({.pipeline = "videotestsrc pattern=http://admin:secret@camera"}),
              AllOf(HasSubstr("pattern"), Not(HasSubstr("secret"))));
}

TEST(LiveCamera, NamesThePackageOfAnElementThatIsNotInstalled) {
  ASSERT_EQ(refusal({.url = "http://127.0.0.1:9/"}), "");
  GstRegistry* registry = gst_registry_get();
  GstPluginFeature* demuxer = gst_registry_lookup_feature(registry, "multipartdemux");
  ASSERT_NE(demuxer, nullptr);
  gst_registry_remove_feature(registry, demuxer);
  EXPECT_EQ(refusal({.url = "http://127.0.0.1:9/"}),
            "camera: needs GStreamer's element multipartdemux, which is not installed: apt-get install "
            "gstreamer1.0-plugins-good");
  gst_registry_add_feature(registry, demuxer);
  gst_object_unref(demuxer);
}

TEST(LiveCamera, NamesThePackageOfDecodersIfThereIsNone) {
  const auto camera = opened({.pipeline = "videotestsrc ! video/x-raw,format=GRAY8 ! "
                                          "capssetter join=false replace=true caps=video/x-nothing ! "
                                          "decodebin"});
  EXPECT_TRUE(eventually_says(*camera, "video/x-nothing decoder: apt-get install gstreamer1.0-libav"));
}

TEST(LiveCamera, ASourceIsExactlyOne) {
  EXPECT_THAT(refusal({}), HasSubstr("0 of device, url"));
}

}  // namespace
}  // namespace aisle
