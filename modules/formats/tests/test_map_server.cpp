#include <gmock/gmock.h>

#include <stdexcept>

#include "aisle/formats/map_server.hpp"

namespace aisle {
namespace {

/// Two cells wide, one high: a wall, then free floor.
OccupancyImage two_cells() {
  OccupancyImage image;
  image.width = 2;
  image.height = 1;
  image.origin_m = {-1.5, 2};
  image.cells = {kCellOccupied, kCellFree};
  return image;
}

TEST(MapServer, ThePictureIsABinaryPgm) {
  EXPECT_EQ(pgm_bytes(two_cells()), std::string("P5\n2 1\n255\n\0\xfe", 13));
}

TEST(MapServer, TheYamlFileNamesPictureResolutionAndLowerLeftCorner) {
  EXPECT_EQ(map_server_yaml(two_cells(), "map.pgm"),
            "image: map.pgm\n"
            "resolution: 0.05\n"
            "origin: [-1.500000, 2.000000, 0.0]\n"
            "negate: 0\n"
            "occupied_thresh: 0.65\n"
            "free_thresh: 0.196\n");
}

/// map_server's rule: occupancy p = (255 - value) / 255, compared with the two thresholds.
TEST(MapServer, TheThresholdsTellTheThreeKindsOfCellsApart) {
  const auto occupancy = [](std::uint8_t value) { return (255.0 - value) / 255; };
  EXPECT_GT(occupancy(kCellOccupied), 0.65);
  EXPECT_LT(occupancy(kCellFree), 0.196);
  EXPECT_GT(occupancy(kCellUnknown), 0.196);
  EXPECT_LT(occupancy(kCellUnknown), 0.65);
}

TEST(MapServer, CellsMustFillThePicture) {
  OccupancyImage image = two_cells();
  image.cells.push_back(kCellFree);
  EXPECT_THROW(pgm_bytes(image), std::invalid_argument);
  EXPECT_THROW(pgm_bytes(OccupancyImage{}), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
