#include <gmock/gmock.h>

#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/vision/route/route_region.hpp"

namespace aisle {
namespace {

constexpr int kRoomWidth = 320, kRoomHeight = 240;

/// A corridor: the floor is a trapezium up to row 120, everything else wall.
bool is_floor(int u, int v) {
  return v >= 120 && std::abs(u - 159.5) < 20 + (v - 120);
}

struct Paint {
  std::uint8_t red = 0, green = 0, blue = 0;
};

Image corridor(const Paint& floor, const Paint& wall, int channels = 3) {
  Image image(kRoomWidth, kRoomHeight, channels);
  for (int v = 0; v < kRoomHeight; ++v) {
    for (int u = 0; u < kRoomWidth; ++u) {
      const Paint& paint = is_floor(u, v) ? floor : wall;
      std::uint8_t* pixel = image.row(v) + channels * u;
      pixel[0] = paint.red;
      if (channels == 3) pixel[1] = paint.green, pixel[2] = paint.blue;
    }
  }
  return image;
}

/// Intersection over union with the true floor.
double overlap(const RouteRegion& region) {
  int both = 0, either = 0;
  for (int v = 0; v < kRoomHeight; ++v) {
    for (int u = 0; u < kRoomWidth; ++u) {
      const bool found = region.mask.row(v)[u] != 0;
      both += static_cast<int>(found && is_floor(u, v));
      either += static_cast<int>(found || is_floor(u, v));
    }
  }
  return static_cast<double>(both) / either;
}

TEST(RouteRegion, IsTheFloorOfACorridorInGreyAndInColour) {
  EXPECT_GE(overlap(find_route_region(corridor({150}, {90}, 1))), 0.97);
  EXPECT_GE(overlap(find_route_region(corridor({90}, {150}, 1))), 0.97);
  EXPECT_GE(overlap(find_route_region(corridor({140, 120, 90}, {90, 110, 150}))), 0.97);
}

TEST(RouteRegion, IsTheWholeImageWhereThereIsOnlyFloor) {
  EXPECT_EQ(find_route_region(corridor({120}, {120}, 1)).share, 1);
}

TEST(RouteRegion, EmptyAndTinyImagesAreNoTrouble) {
  EXPECT_EQ(find_route_region({}).mask, Image());
  for (const int size : {1, 2, 5, 33}) {
    const RouteRegion region = find_route_region(Image(size, size, 3));
    EXPECT_EQ(region.mask.width_px, size);
    EXPECT_EQ(region.share, 1);
  }
}

TEST(RouteRegion, DoesNotDependOnTheImagesBefore) {
  RouteRegionFinder finder;
  Image mask;
  for (const Image& image : {corridor({150}, {90}, 1), corridor({140, 120, 90}, {90, 110, 150}),
                             Image(33, 20, 3), corridor({90}, {150}, 1)}) {
    finder.find(image, mask);
    EXPECT_EQ(mask, find_route_region(image).mask);
  }
}

TEST(RouteMiddle, IsHalfwayBetweenTheMiddlesOfTwoScanLines) {
  Image mask(10, 10);
  for (int u = 2; u <= 4; ++u) mask.row(3)[u] = 255;
  mask.row(3)[8] = 255;  // a lesser part
  for (int u = 5; u <= 8; ++u) mask.row(9)[u] = 255;
  const auto middle = find_route_middle(mask, 3, 9);
  ASSERT_TRUE(middle.has_value());
  EXPECT_EQ(middle->far_px, Vec2(3, 3));
  EXPECT_EQ(middle->near_px, Vec2(6.5, 9));
  EXPECT_EQ(middle->mean_px, Vec2(4.75, 6));
  EXPECT_FALSE(find_route_middle(mask, 5, 9).has_value());
  EXPECT_EQ(find_route_middle(mask, 3, 9, 4, 10)->far_px, Vec2(4, 3)) << "columns before 4 are masked";
}

}  // namespace
}  // namespace aisle
