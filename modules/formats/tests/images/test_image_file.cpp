#include <gdk-pixbuf/gdk-pixbuf.h>
#include <gmock/gmock.h>
#include <webp/encode.h>
#include <zlib.h>

#include <memory>

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

/// A grey PNG of two pixels, 0 and 253, whose tRNS chunk makes 253 transparent: zlib level 0 written by hand.
std::string grey_png_with_trns() {
  const auto chunk = [](const std::string& typed) {
    const auto number = [](std::uint32_t value) {
      std::string bytes;
      for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
      return bytes;
    };
    const auto check =
        crc32(0, reinterpret_cast<const Bytef*>(typed.data()), static_cast<uInt>(typed.size()));
    return number(static_cast<std::uint32_t>(typed.size() - 4)) + typed +
           number(static_cast<std::uint32_t>(check));
  };
  const std::string row("\0\0\xfd", 3);
  std::string packed(64, '\0');
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(row.data()),
           row.size());
  packed.resize(size);
  return "\x89PNG\r\n\x1a\n" + chunk(std::string("IHDR\0\0\0\2\0\0\0\1\x08\0\0\0\0", 17)) +
         chunk(std::string("tRNS\0\xfd", 6)) + chunk("IDAT" + packed) + chunk("IEND");
}

TEST(ImageFile, TransparencyIsReadFromAlphaAndFromTrns) {
  TransparentImage image{noise(2, 1, 3), {0, 1}};
  const auto alpha = parse_transparent_image(png_bytes(image), "p.png");
  ASSERT_TRUE(alpha.ok());
  EXPECT_EQ(alpha->image, image.image);
  EXPECT_EQ(alpha->transparent, image.transparent);
  const auto trns = parse_transparent_image(grey_png_with_trns(), "p.png");
  ASSERT_TRUE(trns.ok()) << to_string(trns.problems());
  EXPECT_THAT(trns->image.bytes, testing::ElementsAre(0, 253));
  EXPECT_THAT(trns->transparent, testing::ElementsAre(0, 1));
  const auto opaque = parse_transparent_image(png_bytes(noise(2, 1, 1)), "p.png");
  EXPECT_THAT(opaque->transparent, testing::IsEmpty());
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

TEST(ImageFile, StatedSizesAreRefusedBeforeMemoryIsTaken) {
  std::string png = png_bytes(Image(8, 8));
  png.replace(16, 8, std::string("\0\0\x40\0\0\0\x40\0", 8));  // 16384 x 16384
  const auto crc = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(png.data() + 12), 17));
  for (std::size_t i = 0; i < 4; ++i) png[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
  EXPECT_THAT(to_string(parse_image(png, "p.png").problems()),
              HasSubstr("p.png: has 16384 x 16384 pixels; at most"));
  EXPECT_THAT(to_string(parse_image("P5 30000 2 255\n", "p.pgm").problems()),
              HasSubstr("has 30000 x 2 pixels"));
}

constexpr int kWidth_px = 9, kHeight_px = 7;

/// Pixels of 3 or 4 channels, each another value.
Image counting(int channels) {
  Image image(kWidth_px, kHeight_px, channels);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = static_cast<std::uint8_t>(255 - i);
  return image;
}

std::string saved_by_pixbuf(const Image& image, const char* type) {
  const std::unique_ptr<GdkPixbuf, void (*)(gpointer)> pixbuf(
      gdk_pixbuf_new_from_data(image.bytes.data(), GDK_COLORSPACE_RGB, image.channels == 4 ? TRUE : FALSE, 8,
                               image.width_px, image.height_px, static_cast<int>(image.row_bytes()), nullptr,
                               nullptr),
      g_object_unref);
  gchar* bytes = nullptr;
  gsize size = 0;
  EXPECT_TRUE(gdk_pixbuf_save_to_buffer(pixbuf.get(), &bytes, &size, type, nullptr, nullptr)) << type;
  std::string file(bytes, size);
  g_free(bytes);
  return file;
}

std::string webp(const Image& image) {
  const auto encode = image.channels == 4 ? WebPEncodeLosslessRGBA : WebPEncodeLosslessRGB;
  std::uint8_t* bytes = nullptr;
  const std::size_t size = encode(image.bytes.data(), image.width_px, image.height_px,
                                  static_cast<int>(image.row_bytes()), &bytes);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  WebPFree(bytes);
  return file;
}

TEST(ImageFile, EveryKindIsReadToTheLastBit) {
  const Image image = counting(3);
  const std::string ppm = "P6 9 7 255\n" + std::string(image.bytes.begin(), image.bytes.end());
  for (const std::string& file :
       {png_bytes(image), ppm, saved_by_pixbuf(image, "png"), saved_by_pixbuf(image, "bmp"),
        saved_by_pixbuf(image, "tiff"), webp(image)}) {
    const auto read = parse_image(file, "p");
    ASSERT_TRUE(read.ok()) << file.substr(0, 4) << to_string(read.problems());
    EXPECT_EQ(*read, image) << file.substr(0, 4);
  }
  const auto grey = parse_image("P5 2 1 255\n\x07\xff", "p");
  ASSERT_TRUE(grey.ok());
  EXPECT_EQ(grey->channels, 1);
  EXPECT_THAT(grey->bytes, testing::ElementsAre(7, 255));
}

TEST(ImageFile, ACutOffFileOfAnyKindIsRefused) {
  const Image image = counting(3);
  const std::string ppm = "P6 9 7 255\n" + std::string(image.bytes.begin(), image.bytes.end());
  for (const std::string& file :
       {ppm, saved_by_pixbuf(image, "bmp"), saved_by_pixbuf(image, "tiff"), webp(image)}) {
    for (const std::size_t left : {file.size() / 4, file.size() / 2, file.size() - 30})
      EXPECT_FALSE(parse_image(file.substr(0, left), "p").ok()) << file.substr(0, 4) << " " << left;
  }
}

TEST(ImageFile, WhatShowsThroughIsReadFromEveryKindThatSaysIt) {
  Image pixels = counting(4);
  for (std::size_t i = 3; i < pixels.bytes.size(); i += 4) pixels.bytes[i] = i % 8 == 3 ? 255 : 100;
  for (const std::string& file :
       {saved_by_pixbuf(pixels, "png"), saved_by_pixbuf(pixels, "tiff"), webp(pixels)}) {
    const auto read = parse_transparent_image(file, "p");
    ASSERT_TRUE(read.ok()) << file.substr(0, 4) << to_string(read.problems());
    ASSERT_EQ(read->transparent.size(), std::size_t{kWidth_px * kHeight_px}) << file.substr(0, 4);
    for (std::size_t i = 0; i < read->transparent.size(); ++i)
      EXPECT_EQ(read->transparent[i], i % 2) << file.substr(0, 4);
    EXPECT_EQ(read->image.channels, 3);
    EXPECT_EQ(read->image.bytes[2], pixels.bytes[2]);
  }
}

TEST(ImageFile, AJpegOfACameraIsGreyOrColourAsItIs) {
  const auto grey = parse_image(jpeg_bytes(noise(16, 16, 1), 100), "p.jpg");
  ASSERT_TRUE(grey.ok());
  EXPECT_EQ(grey->channels, 1);
  const auto colour = parse_image(saved_by_pixbuf(counting(3), "jpeg"), "p.jpg");
  ASSERT_TRUE(colour.ok());
  EXPECT_EQ(colour->channels, 3);
}

}  // namespace
}  // namespace aisle
