#pragma once

#include "aisle/simulation/operators/operator.hpp"
#include "live_control.hpp"

namespace aisle {

/// The operator of a simulated vehicle that is driven through the live server.
class LiveOperator final : public Operator {
 public:
  /// @param control  must outlive the operator
  explicit LiveOperator(LiveControl& control) : hand_(control.hand()) {
    control.state().is_driven_by_hand = true;
  }

  OperatorInput look(const OperatorView& view) override { return hand_.look(view.stamp_s); }

 private:
  LiveHand& hand_;
};

}  // namespace aisle
