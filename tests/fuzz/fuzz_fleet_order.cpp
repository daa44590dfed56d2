#include <string>

#include "aisle/fleet/order_json.hpp"
#include "aisle/fleet/order_tracker.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

namespace {

bool is_released(const Order& order, std::uint32_t sequence) {
  for (const OrderNode& node : order.nodes) {
    if (node.sequence == sequence) return node.released;
  }
  return false;
}

}  // namespace

/// The message as an order or as instant actions, taken by a vehicle that reaches whatever it is sent to.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view message = fuzz_text(bytes, size);
  OrderTracker tracker({"hall", [](const std::string&) { return std::optional<Vec2>(Vec2(1, 0)); },
                        [](const Vec2&) { return std::string(); }},
                       1e9);
  const auto order = read_order(message);
  if (order.ok()) tracker.take(*order, Pose2());
  if (const auto actions = read_instant_actions(message); actions.ok()) tracker.take(*actions);
  const std::size_t steps_max = order.ok() ? 4 * order->nodes.size() + 8 : 8;
  for (std::size_t step = 0; step < steps_max; ++step) {
    tracker.step(static_cast<double>(step), true);
    const auto target = tracker.target();
    if (!target) continue;
    require(order.ok() && is_released(*order, target->sequence));
    tracker.arrive();
  }
  return 0;
}
