#include <gmock/gmock.h>

#include "orders.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;
using Status = ActionState::Status;

const std::optional<Pose2> kAtStart = Pose2{};

class OrderTracking : public testing::Test {
 protected:
  Status status(const std::string& id) const {
    for (const ActionState& one : tracker.state().actions) {
      if (one.id == id) return one.status;
    }
    ADD_FAILURE() << "there is no action " << id;
    return Status::kFailed;
  }
  std::string error() const {
    return tracker.state().errors.empty() ? "" : tracker.state().errors.back().type;
  }
  std::string target_order() const { return tracker.target() ? tracker.target()->order_id : ""; }
  std::uint32_t target() const { return tracker.target() ? tracker.target()->sequence : 0; }
  void pass(double seconds, bool is_standing = true) { tracker.step(stamp_s += seconds, is_standing); }

  OrderTracker tracker = straight_tracker();
  double stamp_s = 0;
};

TEST_F(OrderTracking, DrivesToTheEndOfItsBaseAndNotIntoTheHorizon) {
  tracker.take(order_along(0, 2, 4), kAtStart);
  EXPECT_EQ(tracker.state().last_node_id, "n0") << "it stands there already";
  EXPECT_THAT(tracker.state().nodes, SizeIs(4));
  EXPECT_THAT(tracker.state().edges, SizeIs(4));
  EXPECT_EQ(target(), 2U);
  tracker.arrive();
  EXPECT_EQ(tracker.state().last_node_sequence, 2U);
  EXPECT_THAT(tracker.state().edges, SizeIs(3));
  EXPECT_TRUE(tracker.state().wants_base);
  tracker.arrive();
  EXPECT_FALSE(tracker.target()) << "the base ends here";
  tracker.arrive();
  EXPECT_EQ(tracker.state().last_node_id, "n2") << "nothing of the horizon can be reached";
  EXPECT_TRUE(tracker.is_active());
  EXPECT_EQ(tracker.orders_done(), 0U);
}

TEST_F(OrderTracking, AnUpdateStitchesToTheBaseAndReplacesTheHorizon) {
  tracker.take(order_along(0, 1, 4), kAtStart);
  tracker.take(order_along(1, 2, 3, 1), kAtStart);
  EXPECT_THAT(tracker.state().errors, IsEmpty());
  EXPECT_EQ(tracker.state().update_id, 1U);
  EXPECT_THAT(tracker.state().nodes, SizeIs(3)) << "n1, n2, and n3 of the new horizon";
  tracker.arrive();
  tracker.arrive();
  EXPECT_FALSE(tracker.target());
  tracker.take(order_along(2, 3, 3, 2), kAtStart);
  EXPECT_EQ(target(), 6U);
  tracker.arrive();
  EXPECT_FALSE(tracker.is_active());
  EXPECT_EQ(tracker.orders_done(), 1U);
}

TEST_F(OrderTracking, AnOrderThatIsDoneCanBeContinued) {
  tracker.take(order_along(0, 1, 1), kAtStart);
  tracker.arrive();
  EXPECT_EQ(tracker.orders_done(), 1U);
  tracker.take(order_along(1, 2, 2, 1), kAtStart);
  EXPECT_EQ(target(), 4U);
}

TEST_F(OrderTracking, AnUpdateThatDoesNotFitChangesNothing) {
  tracker.take(order_along(0, 2, 3, 5), kAtStart);
  const OrderState before = tracker.state();
  tracker.take(order_along(0, 3, 3, 5), kAtStart);
  EXPECT_EQ(tracker.state(), before) << "the same update again";
  tracker.take(order_along(2, 3, 3, 4), kAtStart);
  EXPECT_EQ(error(), "orderUpdateError") << "an older one";
  tracker.take(order_along(1, 3, 3, 6), kAtStart);
  EXPECT_EQ(error(), "orderUpdateError") << "begins before the end of the base";
  tracker.take(order_along(3, 3, 3, 6), kAtStart);
  EXPECT_EQ(error(), "orderUpdateError") << "begins beyond it";
  EXPECT_EQ(tracker.state().nodes, before.nodes);
  EXPECT_EQ(tracker.state().update_id, 5U);
  EXPECT_EQ(tracker.orders_refused(), 3U);
  tracker.take(order_along(2, 3, 3, 6), kAtStart);
  EXPECT_THAT(tracker.state().errors, IsEmpty()) << "errors of orders last until one is taken";
}

TEST_F(OrderTracking, ANewOrderIsTakenOnlyWhenTheOldOneIsDone) {
  tracker.take(order_along(0, 1, 2), kAtStart);
  tracker.take(order_along(0, 1, 1, 0, "other"), kAtStart);
  EXPECT_EQ(error(), "orderError");
  EXPECT_EQ(tracker.state().order_id, "order");
  tracker.arrive();
  tracker.take(order_along(0, 1, 1, 0, "other"), kAtStart);
  EXPECT_EQ(error(), "orderError") << "it waits for its horizon";
  tracker.take(order_along(1, 2, 2, 1), kAtStart);
  tracker.arrive();
  tracker.take(order_along(2, 3, 3, 0, "other"), Pose2{4, 0, 0});
  EXPECT_EQ(target_order(), "other");
}

TEST_F(OrderTracking, AnOrderBeginsWhereTheVehicleIs) {
  tracker.take(order_along(0, 1, 1), Pose2{0.6, 0, 0});
  EXPECT_EQ(error(), "noRouteError");
  tracker.take(order_along(0, 1, 1), std::nullopt);
  EXPECT_EQ(error(), "noRouteError") << "it does not know where it is";
  Order wide = order_along(0, 1, 1);
  wide.nodes[0].deviation_m = 1;
  tracker.take(wide, Pose2{0.6, 0, 0});
  EXPECT_EQ(target(), 2U);
}

TEST_F(OrderTracking, NodesThatCannotBeReachedAreNoRoute) {
  Order order = order_along(0, 1, 1);
  order.nodes[1].p_map.reset();
  tracker.take(order, kAtStart);
  EXPECT_EQ(error(), "noRouteError") << "a node that nobody knows";
  order.nodes[1].p_map = Vec2(2, 6);
  tracker.take(order, kAtStart);
  EXPECT_EQ(error(), "noRouteError") << "in a wall";
  order = order_along(0, 1, 1);
  order.nodes[1].map_id = "garden";
  tracker.take(order, kAtStart);
  EXPECT_EQ(error(), "noRouteError") << "on another map";
  EXPECT_EQ(tracker.state().order_id, "");
}

TEST_F(OrderTracking, ActionsThatItCannotDoAreRefusedWithTheOrder) {
  Order order = order_along(0, 1, 1);
  order.nodes[1].actions = {instant("pick", "a")};
  tracker.take(order, kAtStart);
  EXPECT_EQ(error(), "orderError");
  order = order_along(0, 1, 1);
  order.edges[0].actions = {wait_action("a", 1)};
  tracker.take(order, kAtStart);
  EXPECT_EQ(error(), "orderError");
}

TEST_F(OrderTracking, AnActionOfANodeRunsWhileTheVehicleStands) {
  Order order = order_along(0, 2, 2);
  order.nodes[1].actions = {wait_action("a", 2)};
  tracker.take(order, kAtStart);
  EXPECT_EQ(status("a"), Status::kWaiting);
  tracker.arrive();
  EXPECT_EQ(status("a"), Status::kInitializing);
  EXPECT_FALSE(tracker.target());
  pass(1, false);
  EXPECT_EQ(status("a"), Status::kInitializing) << "it still rolls";
  pass(1);
  EXPECT_EQ(status("a"), Status::kRunning);
  tracker.take({instant("startPause", "p")});
  pass(5);
  EXPECT_EQ(status("a"), Status::kPaused);
  tracker.take({instant("stopPause", "q")});
  pass(1);
  EXPECT_EQ(status("a"), Status::kRunning) << "the pause does not count";
  pass(2);
  EXPECT_EQ(status("a"), Status::kFinished);
  EXPECT_EQ(target(), 4U);
}

TEST_F(OrderTracking, AnUpdateCanAddAnActionToTheNodeWhereTheVehicleStands) {
  tracker.take(order_along(0, 1, 2), kAtStart);
  tracker.arrive();
  Order update = order_along(1, 2, 2, 1);
  update.nodes[0].actions = {wait_action("a", 1)};
  tracker.take(update, kAtStart);
  EXPECT_FALSE(tracker.target());
  pass(1);
  pass(1);
  EXPECT_EQ(target(), 4U);
}

TEST_F(OrderTracking, APauseIsOverOnceItIsStopped) {
  tracker.take(order_along(0, 1, 1), kAtStart);
  tracker.take({instant("startPause", "p")});
  EXPECT_FALSE(tracker.target());
  EXPECT_TRUE(tracker.state().is_paused);
  pass(0.1, false);
  EXPECT_EQ(status("p"), Status::kRunning);
  pass(0.1);
  EXPECT_EQ(status("p"), Status::kFinished);
  tracker.take({instant("stopPause", "q")});
  EXPECT_EQ(status("q"), Status::kFinished);
  EXPECT_EQ(target(), 2U);
}

TEST_F(OrderTracking, ACancelledOrderIsGoneOnceTheVehicleStands) {
  Order order = order_along(0, 1, 2);
  order.nodes[1].actions = {wait_action("a", 2)};
  tracker.take(order, kAtStart);
  tracker.take({instant("cancelOrder", "c")});
  EXPECT_FALSE(tracker.target());
  EXPECT_EQ(status("a"), Status::kFailed);
  pass(0.1, false);
  EXPECT_EQ(status("c"), Status::kRunning);
  EXPECT_THAT(tracker.state().nodes, SizeIs(2));
  pass(0.1);
  EXPECT_EQ(status("c"), Status::kFinished);
  EXPECT_THAT(tracker.state().nodes, IsEmpty());
  EXPECT_THAT(tracker.state().edges, IsEmpty());
  EXPECT_EQ(tracker.orders_done(), 0U);
  tracker.take(order_along(0, 1, 1, 1), kAtStart);
  EXPECT_EQ(error(), "orderUpdateError") << "it cannot be revived";
  tracker.take(order_along(0, 1, 1, 0, "next"), Pose2{1, 0, 0});
  EXPECT_EQ(target_order(), "next") << "from the node that it came from";
  EXPECT_EQ(target(), 0U);
}

TEST_F(OrderTracking, AnOrderThatIsCancelledDuringItsLastActionIsNotDone) {
  Order order = order_along(0, 1, 1);
  order.nodes[1].actions = {wait_action("a", 2)};
  tracker.take(order, kAtStart);
  tracker.arrive();
  tracker.take({instant("cancelOrder", "c")});
  pass(0.1, false);
  pass(0.1);
  EXPECT_EQ(status("c"), Status::kFinished);
  EXPECT_EQ(tracker.orders_done(), 0U);
}

TEST_F(OrderTracking, WithoutAnOrderThereIsNothingToCancel) {
  tracker.take({instant("cancelOrder", "c")});
  EXPECT_EQ(status("c"), Status::kFailed);
  EXPECT_EQ(error(), "noOrderToCancel");
}

TEST_F(OrderTracking, RequestsAreAnsweredOnce) {
  tracker.take({instant("stateRequest", "s"), instant("factsheetRequest", "f")});
  tracker.take({instant("stateRequest", "s")});
  EXPECT_TRUE(tracker.take_state_request());
  EXPECT_FALSE(tracker.take_state_request());
  EXPECT_TRUE(tracker.take_factsheet_request());
  EXPECT_FALSE(tracker.take_factsheet_request());
  EXPECT_EQ(status("s"), Status::kFinished);
  tracker.take({instant("dance", "d")});
  EXPECT_EQ(status("d"), Status::kFailed);
}

TEST_F(OrderTracking, AnInitialPoseIsSettledByTheVehicle) {
  FleetAction action = instant("initPosition", "i");
  action.parameters = {{"x", 1.0}, {"y", 2}, {"theta", 0.5}, {"mapId", "hall"}, {"lastNodeId", "n3"}};
  tracker.take({action});
  EXPECT_EQ(status("i"), Status::kRunning);
  const auto pose = tracker.take_initial_pose();
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->T_map_vehicle.y, 2);
  EXPECT_FALSE(tracker.take_initial_pose());
  tracker.settle_initial_pose({});
  EXPECT_EQ(status("i"), Status::kFinished);
  EXPECT_EQ(tracker.state().last_node_id, "n3");
  action.id = "j";
  action.parameters.erase("theta");
  tracker.take({action});
  EXPECT_EQ(status("j"), Status::kFailed);
}

TEST_F(OrderTracking, AMasterThatAsksForeverDoesNotFillTheState) {
  for (int i = 0; i < 1000; ++i) tracker.take({instant("stateRequest", std::to_string(i))});
  EXPECT_THAT(tracker.state().actions, SizeIs(100));
  for (int i = 0; i < 100; ++i) tracker.refuse("order", {{{"", 0, "nodes"}, std::to_string(i)}});
  EXPECT_THAT(tracker.state().errors, SizeIs(20));
}

TEST_F(OrderTracking, WhatBlocksTheEdgeIsReportedUntilItIsPassed) {
  tracker.take(order_along(0, 1, 1), kAtStart);
  tracker.block("a box");
  EXPECT_EQ(error(), "pathBlocked");
  tracker.arrive();
  EXPECT_THAT(tracker.state().errors, IsEmpty());
}

}  // namespace
}  // namespace aisle
