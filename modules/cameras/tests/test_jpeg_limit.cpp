#include "jpeg_limit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "aisle/formats/images/image_file.hpp"

namespace aisle {
namespace {

TEST(JpegSize, IsThatOfTheImage) {
  for (const int channels : {1, 3}) {
    const auto size = jpeg_size(jpeg_bytes(Image(640, 48, channels), 80));
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width_px, 640);
    EXPECT_EQ(size->height_px, 48);
  }
}

TEST(JpegSize, IsFoundBehindFillBytesAndRubbish) {
  const std::string jpeg = jpeg_bytes(Image(320, 24), 80);
  const std::string odd = jpeg.substr(0, 2) + "rubbish" + std::string(5, '\xff') + jpeg.substr(3);
  const auto size = jpeg_size(odd);
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width_px, 320);
}

TEST(JpegSize, IsNotLookedForInTheImagesData) {
  EXPECT_FALSE(jpeg_size(""));
  EXPECT_FALSE(jpeg_size("\xff"));
  EXPECT_FALSE(jpeg_size("no image"));
  EXPECT_FALSE(jpeg_size("\xff\xd8\xff\xda\xff\xc0\x01\x01\x08\x01\x01\x01\x01"));
}

RC_GTEST_PROP(JpegSize, NoBytesDoHarm, (const std::string& bytes)) {
  jpeg_size(bytes);
  jpeg_size("\xff\xd8\xff" + bytes);
}

}  // namespace
}  // namespace aisle
