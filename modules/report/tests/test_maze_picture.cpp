#include "aisle/report/maze_picture.hpp"

#include <gif_lib.h>
#include <gmock/gmock.h>

#include <cstring>

#include "aisle/exploration/maze_generator.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Bytes {
  const std::string& all;
  std::size_t used = 0;
};

int take(GifFileType* file, GifByteType* to, int size) {
  auto& bytes = *static_cast<Bytes*>(file->UserData);
  const std::size_t count = std::min(static_cast<std::size_t>(size), bytes.all.size() - bytes.used);
  std::memcpy(to, bytes.all.data() + bytes.used, count);
  bytes.used += count;
  return static_cast<int>(count);
}

TEST(MazePicture, IsTheSameForTheSameRun) {
  const GridWorld world = generate_maze({.width = 6, .height = 4}, Random(3));
  const MazePicture picture{world, GridRuleSet::kShortcut, "six by four"};
  EXPECT_THAT(svg(picture), HasSubstr("<svg"));
  EXPECT_EQ(svg(picture), svg(picture));
  EXPECT_EQ(gif(picture), gif(picture));
}

TEST(MazePicture, HasOneFramePerMove) {
  const GridWorld world = generate_maze({.width = 6, .height = 4}, Random(3));
  const std::string film = gif({world, GridRuleSet::kCells, ""});
  Bytes bytes{film};
  int error = 0;
  GifFileType* file = DGifOpen(&bytes, take, &error);
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(DGifSlurp(file), GIF_OK);
  EXPECT_EQ(file->ImageCount, 2 * (24 - 1) + 1);
  DGifCloseFile(file, nullptr);
}

TEST(MazePicture, OfALongRunHasNotManyMoreThanFiveHundredFrames) {
  const GridWorld world = generate_maze({.width = 60, .height = 60}, Random(3));
  const std::string film = gif({world, GridRuleSet::kPublished, ""});
  Bytes bytes{film};
  int error = 0;
  GifFileType* file = DGifOpen(&bytes, take, &error);
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(DGifSlurp(file), GIF_OK);
  EXPECT_LE(file->ImageCount, 502);
  DGifCloseFile(file, nullptr);
}

TEST(MazePicture, IsNotDrawnOfHugeWorlds) {
  const GridWorld large(256, 256);
  EXPECT_THAT(MazePicture{large}.problems(), IsEmpty());
  const GridWorld huge(257, 1);
  EXPECT_THAT(MazePicture{huge}.problems(), Not(IsEmpty()));
}

}  // namespace
}  // namespace aisle
