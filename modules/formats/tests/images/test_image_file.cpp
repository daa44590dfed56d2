#include <gmock/gmock.h>

#include "aisle/core/random.hpp"
#include "aisle/formats/images/image_file.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

Image noise(int width, int height, int channels) {
  Random random(7);
  Image image(width, height, channels);
  for (std::uint8_t& value : image.bytes) value = static_cast<std::uint8_t>(random.index(256));
  return image;
}

TEST(ImageFile, PngKeepsGreyAndColourExactly) {
  for (const int channels : {1, 3}) {
    const Image image = noise(33, 17, channels);
    const Result<Image> read = parse_image(png_bytes(image), "p.png");
    ASSERT_TRUE(read.ok()) << to_string(read.problems());
    EXPECT_EQ(*read, image);
  }
}

TEST(ImageFile, JpegKeepsColoursInTheirOrder) {
  Image red(16, 16, 3);
  for (std::size_t i = 0; i < red.bytes.size(); i += 3) red.bytes[i] = 200;
  const Result<Image> read = parse_image(jpeg_bytes(red, 95), "p.jpg");
  ASSERT_TRUE(read.ok());
  EXPECT_NEAR(read->row(8)[0], 200, 8);
  EXPECT_NEAR(read->row(8)[2], 0, 8);
}

TEST(ImageFile, WhatIsNoImageIsRefusedWithItsName) {
  const std::string png = png_bytes(noise(64, 64, 1));
  for (const std::string& bytes :
       {std::string(), std::string("hello"), std::string(1000, '\0'), png.substr(0, 20)}) {
    const Result<Image> read = parse_image(bytes, "p.png");
    ASSERT_FALSE(read.ok());
    EXPECT_THAT(to_string(read.problems()), HasSubstr("p.png: is"));
  }
  EXPECT_FALSE(read_image("/").ok());
  EXPECT_FALSE(read_image("/nonexistent.png").ok());
}

TEST(ImageFile, ACutOffOrChangedPngIsRefusedWithThePlace) {
  const std::string png = png_bytes(noise(64, 64, 1));
  for (std::size_t size = 8; size < png.size(); size += 97) {
    const Result<Image> read = parse_image(png.substr(0, size), "p.png");
    ASSERT_FALSE(read.ok());
    EXPECT_THAT(to_string(read.problems()), HasSubstr("cut off"));
  }
  for (std::size_t at = 12; at < png.size(); at += 61) {
    std::string changed = png;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    EXPECT_FALSE(parse_image(changed, "p.png").ok()) << at;
  }
}

TEST(ImageFile, ACutOffJpegIsRefused) {
  const std::string jpeg = jpeg_bytes(noise(64, 64, 1), 90);
  const Result<Image> read = parse_image(jpeg.substr(0, jpeg.size() / 2), "p.jpg");
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(to_string(read.problems()), HasSubstr("p.jpg: is a JPEG that is cut off"));
}

}  // namespace
}  // namespace aisle
