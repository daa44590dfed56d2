#include "debian_package.hpp"

#include <gmock/gmock.h>

namespace aisle {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(DebianPackage, IsThatOfTheElement) {
  for (const auto& [element, package] : std::initializer_list<std::pair<const char*, const char*>>{
           {"videoconvert", "gstreamer1.0-plugins-base"},
           {"decodebin", "gstreamer1.0-plugins-base"},
           {"v4l2src", "gstreamer1.0-plugins-good"},
           {"jpegdec", "gstreamer1.0-plugins-good"},
           {"rtspsrc", "gstreamer1.0-plugins-good"},
           {"rtph264depay", "gstreamer1.0-plugins-good"},
           {"h264parse", "gstreamer1.0-plugins-bad"},
           {"avdec_h264", "gstreamer1.0-libav"}})
    EXPECT_THAT(how_to_install(element), EndsWith(std::string("apt-get install ") + package)) << element;
}

TEST(DebianPackage, IsNotGuessed) {
  EXPECT_THAT(how_to_install("mycamerasrc"), HasSubstr("does not know"));
  EXPECT_THAT(how_to_install(""), HasSubstr("does not know"));
}

}  // namespace
}  // namespace aisle
