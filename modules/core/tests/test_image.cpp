#include <gmock/gmock.h>

#include "aisle/core/image.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;

TEST(Image, GreyWeighsTheColoursAndKeepsGreyAsItIs) {
  Image image(5, 1, 3);
  image.bytes = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 7, 7, 7};
  EXPECT_THAT(to_grey(image).bytes, ElementsAre(76, 150, 29, 255, 7));
  EXPECT_EQ(to_grey(to_grey(image)), to_grey(image));
}

TEST(Image, GreyImagesAreNotCopied) {
  Image coloured(1, 1, 3), converted;
  coloured.bytes = {255, 255, 255};
  const Image grey = to_grey(coloured);
  EXPECT_EQ(&as_grey(grey, converted), &grey);
  EXPECT_EQ(as_grey(coloured, converted), grey);
}

TEST(Image, AShrunkPixelIsTheMeanOfThoseThatItCovers) {
  Image image(4, 2);
  image.bytes = {10, 20, 30, 40,  //
                 30, 40, 50, 60};
  EXPECT_THAT(shrunk(image, 2, 1).bytes, ElementsAre(25, 45));
  EXPECT_THAT(shrunk(image, 1, 2).bytes, ElementsAre(25, 45));
  EXPECT_EQ(shrunk(image, 4, 2), image);
}

TEST(Image, MorePixelsThanThereAreRepeatThem) {
  Image image(2, 1, 3);
  image.bytes = {1, 2, 3, 4, 5, 6};
  EXPECT_THAT(shrunk(image, 4, 1).bytes, ElementsAre(1, 2, 3, 1, 2, 3, 4, 5, 6, 4, 5, 6));
}

}  // namespace
}  // namespace aisle
