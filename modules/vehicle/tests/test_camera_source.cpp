#include "aisle/vehicle/camera_source.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::string refusal(const CameraSource& source) {
  return to_string(source.problems());
}

TEST(CameraSource, ComesFromExactlyOneOrigin) {
  EXPECT_THAT(refusal({}), HasSubstr("0 of device, url, folder and pipeline are given"));
  EXPECT_THAT(refusal({.device = "/dev/video0", .folder = "frames"}), HasSubstr("2 of device"));
  for (const CameraSource& source :
       {CameraSource{.device = "/dev/video0"}, CameraSource{.url = "rtsp://camera/live"},
        CameraSource{.url = "https://camera:8443/video?size=3"}, CameraSource{.folder = "my frames"},
        CameraSource{.pipeline = "videotestsrc"}}) {
    EXPECT_THAT(refusal(source), IsEmpty());
  }
}

TEST(CameraSource, UrlsAreThoseOfCamerasAndAreNotShown) {
  for (const char* url : {"file:///etc/passwd", "admin:secret@camera", "rtsp:/secret", "rtsp://a:secret @b"})
    EXPECT_THAT(refusal({.url = url}), AllOf(HasSubstr("url: "), Not(HasSubstr("secret")))) << url;
}

TEST(CameraSource, NumbersKeepTheirRanges) {
  EXPECT_THAT(refusal({.folder = "frames", .rate_hz = 0}), HasSubstr("rate_hz: 0 is outside"));
  EXPECT_THAT(refusal({.folder = "frames", .silent_max_s = std::numeric_limits<double>::quiet_NaN()}),
              HasSubstr("silent_max_s: 'nan' is not a number"));
  EXPECT_THAT(refusal({.folder = "frames", .width_px = 640}), HasSubstr("width_px: and height_px"));
}

TEST(CameraSource, IsSetByItsKeys) {
  CameraSource source;
  FieldList fields = fields_of(source);
  EXPECT_THAT(fields.assign("colour", "true", {}), IsEmpty());
  EXPECT_THAT(fields.assign("latency_ms", "50", {}), IsEmpty());
  EXPECT_TRUE(source.is_colour);
  EXPECT_EQ(source.latency_ms, 50);
  for (const auto& [key, text] : source.origins()) *text = key;
  EXPECT_EQ(source.url, "url");
  EXPECT_EQ(source.pipeline, "pipeline");
}

}  // namespace
}  // namespace aisle
