#include "bags/bag_files.hpp"

#include <gmock/gmock.h>

#include "bag_writers.hpp"
#include "session_samples.hpp"

namespace aisle {
namespace {

TEST(BagFiles, NamesAreSortedByTheirNumbers) {
  EXPECT_TRUE(natural_less("bag_2.db3", "bag_10.db3"));
  EXPECT_TRUE(natural_less("bag_02.db3", "bag_10.db3"));
  EXPECT_FALSE(natural_less("bag_10.db3", "bag_2.db3"));
  EXPECT_TRUE(natural_less("a", "ab"));
}

TEST(BagFiles, MetadataThatIsNoYamlIsSaidAndTheFilesAreTaken) {
  const SessionPlace place;
  write_file(place / "bag/x_0.mcap", "");
  write_file(place / "bag/metadata.yaml", "rosbag2_bagfile_information: [");
  const auto bag = bag_files(place / "bag");
  ASSERT_TRUE(bag.ok());
  EXPECT_THAT(bag->paths, testing::ElementsAre(place / "bag/x_0.mcap"));
  EXPECT_THAT(to_string(bag->warnings), testing::HasSubstr("is not YAML"));
}

}  // namespace
}  // namespace aisle
