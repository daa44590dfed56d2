#include <gmock/gmock.h>

#include "aisle/core/clock.hpp"
#include "mjpeg_viewer.hpp"
#include "opened_camera.hpp"
#include "painted_image.hpp"
#include "pipeline_stream.hpp"
#include "rtsp_viewer.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class NetworkCamera : public testing::Test {
 protected:
  CameraSource source(const std::string& scheme = "http://") const {
    return {.url = scheme + server.address() + "/live", .silent_max_s = 0.5};
  }

  /// Shows an image, and what arrives of it.
  template <class Viewer>
  int shown(Viewer& viewer, LiveCamera& camera, int number) {
    EXPECT_TRUE(viewer.show(painted_image(number)));
    return number_in(*next_image(camera).pixels);
  }

  LocalServer server;
};

TEST_F(NetworkCamera, GivesEveryImageAsSoonAsItIsThere) {
  const auto camera = opened(source());
  const MjpegViewer viewer(server.accept());
  EXPECT_THAT(viewer.request(), HasSubstr("GET /live HTTP/1.1"));
  for (int number = 1; number < 20; ++number) EXPECT_EQ(shown(viewer, *camera, number), number);
  EXPECT_EQ(camera->problem(), "");
  EXPECT_EQ(camera->counts().arrived, 19);
  EXPECT_EQ(camera->counts().dropped, 0);
}

TEST_F(NetworkCamera, StampsAreThoseOfTheArrival) {
  const SteadyClock clock;
  const auto camera = opened(source());
  const MjpegViewer viewer(server.accept());
  for (int number = 1; number < 5; ++number) {
    const double before_s = clock.now_s();
    viewer.show(painted_image(number));
    const LiveImage image = next_image(*camera);
    EXPECT_GT(image.stamp_s, before_s);
    EXPECT_LT(image.stamp_s, clock.now_s());
  }
}

TEST_F(NetworkCamera, WithoutLengthsAnImageEndsWhereTheNextBegins) {
  const auto camera = opened(source());
  const MjpegViewer viewer(server.accept());
  for (int number = 1; number < 5; ++number) {
    viewer.write("--frame\r\nContent-Type: image/jpeg\r\n\r\n" + jpeg_bytes(painted_image(number), 95) +
                 "\r\n");
    if (number > 1) {
      EXPECT_EQ(number_in(*next_image(*camera).pixels), number - 1);
    }
  }
}

TEST_F(NetworkCamera, PixelsAreThoseOfTheJpeg) {
  const auto camera = opened(source());
  const MjpegViewer viewer(server.accept());
  const std::string jpeg = jpeg_bytes(painted_image(77), 80);
  viewer.show_jpeg(jpeg);
  EXPECT_EQ(*next_image(*camera).pixels, *parse_image(jpeg, "jpeg"));
}

TEST_F(NetworkCamera, GivesTheColoursOfTheJpeg) {
  CameraSource coloured = source();
  coloured.is_colour = true;
  const auto camera = opened(coloured);
  const MjpegViewer viewer(server.accept());
  Image image(64, 32, 3);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = i % 3 == 0 ? 200 : 40;
  viewer.show(image);
  const auto pixels = next_image(*camera).pixels;
  ASSERT_EQ(pixels->bytes.size(), image.bytes.size());
  for (std::size_t i = 0; i < image.bytes.size(); ++i) ASSERT_NEAR(pixels->bytes[i], image.bytes[i], 4) << i;
}

TEST_F(NetworkCamera, IsOpenedAgainWhenItComesBack) {
  const auto camera = opened(source());
  {
    const MjpegViewer viewer(server.accept());
    EXPECT_EQ(shown(viewer, *camera, 1), 1);
    server.die();
  }
  EXPECT_TRUE(eventually_says(*camera, "refused"));
  EXPECT_EQ(camera->state(), CameraState::kReopening);
  EXPECT_THAT(camera->problem(), AllOf(HasSubstr(server.address()), EndsWith(": reopening")));
  server.come_back();
  const MjpegViewer viewer(server.accept());
  EXPECT_EQ(shown(viewer, *camera, 2), 2);
  EXPECT_EQ(camera->state(), CameraState::kLive);
  EXPECT_EQ(camera->problem(), "");
  EXPECT_GE(camera->counts().reopened, 2);
}

TEST_F(NetworkCamera, IsOpenedAgainWhenItStalls) {
  const auto camera = opened(source());
  const MjpegViewer stalling(server.accept());
  EXPECT_EQ(shown(stalling, *camera, 1), 1);
  const MjpegViewer viewer(server.accept());
  EXPECT_THAT(camera->problem(), AllOf(HasSubstr("no image for "),
                                       EndsWith(" s from http://" + server.address() + "/live: reopening")));
  EXPECT_EQ(shown(viewer, *camera, 2), 2);
}

TEST_F(NetworkCamera, MayBeAwayAtFirst) {
  server.die();
  const auto camera = opened(source());
  EXPECT_TRUE(eventually_says(*camera, "refused"));
  server.come_back();
  const MjpegViewer viewer(server.accept());
  EXPECT_EQ(shown(viewer, *camera, 3), 3);
}

TEST_F(NetworkCamera, ThatNeverAnswersDoesNotHoldUpTheEnd) {
  const auto camera = opened(source());
  const Socket silent = server.accept();
  EXPECT_NE(silent.read_request(), "");
  EXPECT_TRUE(eventually_says(*camera, "no image for "));
}

TEST_F(NetworkCamera, ImagesOfAnotherSizeAreRefused) {
  const auto camera = opened(source());
  const MjpegViewer viewer(server.accept());
  EXPECT_EQ(shown(viewer, *camera, 1), 1);
  viewer.show(painted_image(2, 64));
  EXPECT_TRUE(eventually_says(*camera, "an image is refused: has 128 x 64 pixels instead of 128 x 48"));
  EXPECT_EQ(shown(viewer, *camera, 3), 3);
  EXPECT_EQ(camera->problem(), "");
  EXPECT_EQ(camera->counts().refused, 1);
}

TEST_F(NetworkCamera, WhatIsNoCameraIsSaid) {
  const auto camera = opened(source());
  MjpegViewer(server.accept(), "404 Not Found", "");
  EXPECT_TRUE(eventually_says(*camera, "Not Found"));
  MjpegViewer(server.accept(), "200 OK\r\nContent-Type: text/html", "<html>Welcome</html>");
  EXPECT_TRUE(eventually_says(*camera, "Boundary not found"));
}

TEST_F(NetworkCamera, BytesThatAreNoImageDoNoHarm) {
  const auto camera = opened(source());
  const MjpegViewer viewer(server.accept());
  viewer.show_jpeg("\xff\xd8\xff\xe0 no image");
  viewer.show_jpeg(jpeg_bytes(painted_image(1), 90).substr(0, 300));
  viewer.show_jpeg("");
  viewer.show(painted_image(2));  // unless the camera has given this viewer up already
  EXPECT_TRUE(eventually(*camera, [&] { return camera->counts().arrived + camera->counts().reopened > 0; }));
}

TEST_F(NetworkCamera, AnImageWithoutAnEndIsGivenUp) {
  const auto stream = PipelineStream::open(source());
  ASSERT_TRUE(stream);
  (*stream)->start();
  const MjpegViewer viewer(server.accept());
  viewer.begin_image(std::size_t{1} << 31);
  const std::string part(1 << 20, 'x');
  for (int i = 0; i < 65; ++i) viewer.write(part);
  StreamNews news;
  while (std::holds_alternative<NothingYet>(news)) news = (*stream)->wait(1);
  ASSERT_TRUE(std::holds_alternative<StreamEnd>(news));
  EXPECT_EQ(std::get<StreamEnd>(news).why, "sends an image without an end");
}

TEST_F(NetworkCamera, AnImageThatWouldTakeGigabytesIsGivenUp) {
  std::string jpeg = jpeg_bytes(painted_image(1), 90);
  const auto size = jpeg.find("\xff\xc0") + 5;  // height and width in the start of frame
  jpeg.replace(size, 4, "\xfd\xe8\xfd\xe8");
  const auto camera = opened(source());
  const MjpegViewer viewer(server.accept());
  viewer.show_jpeg(jpeg);
  EXPECT_TRUE(eventually_says(*camera, "65000 x 65000 pixels is too large"));
}

TEST_F(NetworkCamera, UserAndPasswordAreSentButNeverShown) {
  const auto camera =
      opened({.url = "http://admin:p%40ss@" + server.address() + "/?key=p%40ss", .silent_max_s = 0.5});
  EXPECT_EQ(camera->name(), "http://" + server.address() + "/?...");
  MjpegViewer(server.accept(), "401 Unauthorized\r\nWWW-Authenticate: Basic realm=\"camera\"", "");
  const MjpegViewer viewer(server.accept());
  EXPECT_THAT(viewer.request(), HasSubstr("Authorization: Basic YWRtaW46cEBzcw=="));  // admin:p@ss
  EXPECT_EQ(shown(viewer, *camera, 5), 5);
  server.die();
  EXPECT_TRUE(eventually_says(*camera, "reopening"));
  EXPECT_THAT(camera->problem(), AllOf(Not(HasSubstr("p@ss")), Not(HasSubstr("p%40ss"))));
}

TEST_F(NetworkCamera, AWrongPasswordIsSaidAndNotShown) {
  const auto camera = opened({.url = "http://admin:secret@" + server.address(), .silent_max_s = 0.5});
  for (int i = 0; i < 2; ++i)
    MjpegViewer(server.accept(), "401 Unauthorized\r\nWWW-Authenticate: Basic realm=\"camera\"", "");
  EXPECT_TRUE(eventually_says(*camera, "Unauthorized"));
  EXPECT_THAT(camera->problem(), Not(HasSubstr("secret")));
}

TEST_F(NetworkCamera, SpeaksRtsp) {
  const auto camera = opened(source("rtspt://"));
  RtspViewer viewer(server.accept(), painted_image(0));
  for (int number = 1; number < 10; ++number) EXPECT_EQ(shown(viewer, *camera, number), number);
  EXPECT_EQ(camera->counts().reopened, 0);
}

TEST_F(NetworkCamera, RtspIsOpenedAgainWhenItComesBack) {
  const auto camera = opened(source("rtspt://"));
  {
    RtspViewer viewer(server.accept(), painted_image(0));
    EXPECT_EQ(shown(viewer, *camera, 1), 1);
    server.die();
  }
  EXPECT_TRUE(eventually_says(*camera, "reopening"));
  server.come_back();
  RtspViewer viewer(server.accept(), painted_image(0));
  EXPECT_EQ(shown(viewer, *camera, 2), 2);
}

TEST_F(NetworkCamera, RtspThatNeverAnswersDoesNotHoldUpTheEnd) {
  const auto camera = opened(source("rtspt://"));
  const Socket silent = server.accept();
  EXPECT_NE(silent.read_request(), "");
  EXPECT_TRUE(eventually_says(*camera, "no image for "));
}

}  // namespace
}  // namespace aisle
