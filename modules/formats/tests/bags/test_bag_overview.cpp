#include "aisle/formats/bags/bag_overview.hpp"

#include <gmock/gmock.h>

#include "bag_samples.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

TEST(BagOverview, SaysWhatEveryTopicCouldServeFor) {
  const SessionPlace place;
  auto messages = Recorded{}.messages();
  messages.push_back(written("/chatter", 101, ros::String{"hi"}));
  write_file(place / "bag.mcap", mcap_bytes(messages, {"zstd", 4, false}));
  const auto overview = bag_overview(place / "bag.mcap");
  ASSERT_TRUE(overview.ok());
  ASSERT_THAT(overview->topics, SizeIs(4));
  EXPECT_EQ(overview->messages, 24);
  EXPECT_EQ(overview->topics[0].serves, "mounts");
  EXPECT_THAT(overview->topics[0].frames, ElementsAre("plate -> laser", "base_link -> plate"));
  EXPECT_EQ(overview->topics[1].serves, "odometry");
  EXPECT_THAT(overview->topics[1].frames, ElementsAre("odom -> base_link"));
  EXPECT_NEAR(overview->topics[1].rate_hz, 10, 1e-6);
  EXPECT_EQ(overview->topics[2].serves, "scan");
  EXPECT_EQ(overview->topics[2].topic.messages, 10);
  EXPECT_EQ(overview->topics[3].serves, "not read");
}

}  // namespace
}  // namespace aisle
