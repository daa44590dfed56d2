#include "aisle/vision/places/place_recogniser.hpp"

#include <gmock/gmock.h>

#include <array>
#include <vector>

namespace aisle {
namespace {

/// A corridor's image: doors between these columns, darker than the walls, above a bright floor.
Image corridor(const std::vector<std::array<int, 2>>& doors, int wall_grey = 180) {
  Image image(400, 300);
  for (int v = 0; v < image.height_px; ++v) {
    for (int u = 0; u < image.width_px; ++u) image.row(v)[u] = static_cast<std::uint8_t>(wall_grey);
  }
  for (const auto& [left, right] : doors) {
    for (int v = 40; v < 260; ++v) {
      for (int u = left; u < right; ++u) image.row(v)[u] = static_cast<std::uint8_t>(wall_grey / 3);
    }
  }
  return image;
}

const std::vector<std::vector<std::array<int, 2>>> kPlaces = {
    {{20, 90}, {330, 380}}, {{60, 100}, {130, 150}, {350, 390}}, {{250, 330}}, {{180, 220}, {300, 310}}};

PlaceRecogniser taught() {
  PlaceRecogniser recogniser({});
  for (const auto& doors : kPlaces) recogniser.teach(corridor(doors));
  return recogniser;
}

TEST(PlaceRecogniser, KnowsEveryPlaceAgainInOtherLight) {
  PlaceRecogniser recogniser = taught();
  for (std::size_t place = 0; place < kPlaces.size(); ++place) {
    const auto found = recogniser.recognise(corridor(kPlaces[place], 140));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->view, place);
    EXPECT_TRUE(recogniser.is_sure(*found));
  }
}

TEST(PlaceRecogniser, IsNotSureOfAPlaceThatWasNotTaught) {
  PlaceRecogniser recogniser = taught();
  const auto bare = recogniser.recognise(corridor({}));
  ASSERT_TRUE(bare);
  EXPECT_FALSE(recogniser.is_sure(*bare));
  const auto between = recogniser.recognise(corridor({{5, 25}, {70, 120}, {160, 240}, {255, 290}}));
  ASSERT_TRUE(between);
  EXPECT_FALSE(recogniser.is_sure(*between)) << between->view << " " << between->unlike;
}

TEST(PlaceRecogniser, RecognisesNothingBeforeItWasTaught) {
  EXPECT_FALSE(PlaceRecogniser({}).recognise(corridor({})));
}

}  // namespace
}  // namespace aisle
