#include "folder_stream.hpp"

#include <gmock/gmock.h>

#include <vector>

#include "aisle/formats/images/image_file.hpp"
#include "image_folder_place.hpp"
#include "painted_image.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class ReplayedFolder : public testing::Test {
 protected:
  std::unique_ptr<ImageStream> start(CameraSource source) const {
    source.folder = place.path();
    source.rate_hz = 1000;
    auto stream = FolderStream::open(source);
    EXPECT_TRUE(stream) << to_string(stream.problems());
    (*stream)->start();
    return std::move(*stream);
  }

  ImageFolderPlace place;
};

struct Shown {
  std::vector<Image> images;
  std::vector<double> stamps_s;
  std::vector<std::string> refused;
  StreamEnd end;
};

/// All that comes, or the first images of a stream without an end.
Shown read(ImageStream& stream, std::size_t images_max = 100) {
  Shown shown;
  while (shown.images.size() < images_max) {
    StreamNews news = stream.wait(1);
    if (auto* image = std::get_if<StreamedImage>(&news)) {
      shown.images.push_back(std::move(image->pixels));
      shown.stamps_s.push_back(image->stamp_s);
    }
    if (const auto* refused = std::get_if<RefusedImage>(&news)) shown.refused.push_back(refused->why);
    if (const auto* end = std::get_if<StreamEnd>(&news)) {
      shown.end = *end;
      break;
    }
  }
  return shown;
}

TEST_F(ReplayedFolder, GivesEveryImageInNaturalOrder) {
  place.write("frame_10.jpg", jpeg_bytes(painted_image(10), 90));
  for (const int number : {9, 1, 2})
    place.write("frame_" + std::to_string(number) + ".png", png_bytes(painted_image(number)));
  const Shown shown = read(*start({}));
  ASSERT_EQ(shown.images.size(), 4);
  for (const auto& [index, number] : {std::pair(0, 1), {1, 2}, {2, 9}})
    EXPECT_EQ(shown.images[static_cast<std::size_t>(index)], painted_image(number));
  EXPECT_EQ(number_in(shown.images[3]), 10);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(shown.stamps_s[i], shown.stamps_s[i - 1]);
  EXPECT_TRUE(shown.end.is_final);
  EXPECT_EQ(shown.end.why, "all 4 images were shown, 0 left out");
}

TEST_F(ReplayedFolder, BeginsAgainIfItLoops) {
  for (const int number : {1, 2})
    place.write(std::to_string(number) + ".png", png_bytes(painted_image(number)));
  const Shown shown = read(*start({.loops = true}), 5);
  std::vector<int> numbers;
  for (const Image& image : shown.images) numbers.push_back(number_in(image));
  EXPECT_THAT(numbers, ElementsAre(1, 2, 1, 2, 1));
}

TEST_F(ReplayedFolder, GivesTheColoursThatAreAskedFor) {
  Image red(16, 16, 3);
  for (std::size_t i = 0; i < red.bytes.size(); i += 3) red.bytes[i] = 200;
  place.write("1.png", png_bytes(red));
  place.write("2.png", png_bytes(to_grey(red)));
  const Shown grey = read(*start({}));
  ASSERT_EQ(grey.images.size(), 2);
  EXPECT_EQ(grey.images[0], to_grey(red));
  const Shown colour = read(*start({.is_colour = true}));
  ASSERT_EQ(colour.images.size(), 2);
  EXPECT_EQ(colour.images[0], red);
  EXPECT_EQ(colour.images[1].channels, 3);
  EXPECT_EQ(to_grey(colour.images[1]), to_grey(red));
}

TEST_F(ReplayedFolder, LeavesOutWhatCannotBeUsedAndSaysSo) {
  place.write("1.png", png_bytes(painted_image(1)));
  place.write("2.png", png_bytes(painted_image(2)).substr(0, 100));
  place.write("3.png", png_bytes(painted_image(3, 32)));
  place.write("4.png", png_bytes(painted_image(4)));
  const Shown shown = read(*start({}));
  ASSERT_EQ(shown.images.size(), 2);
  EXPECT_EQ(number_in(shown.images[1]), 4);
  ASSERT_FALSE(shown.refused.empty());
  EXPECT_THAT(shown.refused.front(), AllOf(HasSubstr("3.png"), HasSubstr("128 x 32")));
  EXPECT_EQ(shown.end.why, "all 2 images were shown, 2 left out");
}

TEST_F(ReplayedFolder, WithoutImagesIsAProblem) {
  EXPECT_FALSE(FolderStream::open({.folder = place.path()}));
  EXPECT_FALSE(FolderStream::open({.folder = place.path() + "/none"}));
}

}  // namespace
}  // namespace aisle
