#include "live_pace.hpp"

namespace aisle {
namespace {

constexpr double kLateAtMost_s = 0.5;

}  // namespace

void LivePace::set_rate(double rate) {
  rate_ = rate;
  rest();
}

double LivePace::wait_s(double stamp_s) {
  if (rate_ <= 0) return 0;
  const double now_s = clock_.now_s();
  if (!begun_ || stamp_s < begun_->stamp_s) begun_ = {now_s, stamp_s};
  const double wait_s = begun_->clock_s + (stamp_s - begun_->stamp_s) / rate_ - now_s;
  if (wait_s < -kLateAtMost_s) begun_ = {now_s, stamp_s};
  return wait_s > 0 ? wait_s : 0;
}

}  // namespace aisle
