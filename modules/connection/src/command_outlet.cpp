#include "command_outlet.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kGainedOver_s = 0.25;  // simulators may run faster than commands are sent
constexpr double kLate = 1.5;           // cycles after a decision: the next one is late
constexpr auto kPeriod = std::chrono::duration<double>(CommandOutlet::kPeriod_s);

/// From one value towards another: away from 0 by at most `step`, towards 0 at once.
double gained(double from, double to, double step) {
  const double slow = from * to > 0 ? std::min(std::abs(from), std::abs(to)) : 0;
  return std::copysign(std::min(std::abs(to), slow + step), to);
}

bool is_moving(const Command& command) {
  return command.speed_mps != 0 || command.turn_rate_rad_s != 0;
}

}  // namespace

CommandOutlet::CommandOutlet(std::unique_ptr<WirePublisher> publisher, Settings settings,
                             VehicleDescription vehicle, std::function<double()> now_s,
                             std::function<ros::Stamp_ns()> stamp)
    : publisher_(std::move(publisher)),
      settings_(std::move(settings)),
      vehicle_(std::move(vehicle)),
      now_s_(std::move(now_s)),
      stamp_(std::move(stamp)),
      thread_([this] { run(); }) {}

CommandOutlet::~CommandOutlet() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void CommandOutlet::act(const Command& command) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = within(vehicle_.limits, command);
    wanted_at_s_ = now_s_();
  }
  wake_.notify_all();
}

void CommandOutlet::hold(bool is_held) {
  {
    const std::lock_guard lock(mutex_);
    if (is_held == is_held_) return;
    is_held_ = is_held;
    wanted_ = {};
  }
  wake_.notify_all();
}

void CommandOutlet::fall_silent(bool is_silent) {
  const std::lock_guard lock(mutex_);
  is_silent_ = is_silent;
}

void CommandOutlet::run() {
  std::unique_lock lock(mutex_);
  Command latest = wanted_;
  while (!is_over_) {
    if (!is_silent_) send();
    latest = wanted_;
    const bool was_held = is_held_;
    wake_.wait_for(lock, kPeriod, [&] { return is_over_ || is_held_ != was_held || wanted_ != latest; });
  }
  for (int i = 0; i < kStopsAtEnd; ++i) {
    wanted_ = {};
    send();
    wake_.wait_for(lock, kPeriod, [] { return false; });
  }
}

/// Sends under the lock: the publisher's calls stay in order.
void CommandOutlet::send() {
  const double now_s = now_s_();
  add_commanded(now_s);
  sent_ = present(now_s);
  sent_at_s_ = now_s;
  publisher_->publish(command_cdr(sent_, settings_.kind, vehicle_, stamp_(), settings_.frame));
}

void CommandOutlet::add_commanded(double now_s) {
  const Arc rates = rates_of(sent_, vehicle_);
  const double since_s = std::max(0.0, now_s - sent_at_s_);
  commanded_ = {commanded_.length_m + rates.length_m * since_s,
                commanded_.turn_rad + rates.turn_rad * since_s};
}

Arc CommandOutlet::commanded() {
  const std::lock_guard lock(mutex_);
  return commanded_;
}

/// What is left of a command's speed at an age. A vehicle that was slowed down stands soon when it is told
/// to.
double CommandOutlet::share_of(double age_s) const {
  const double late_s = std::min(kLate * vehicle_.cycle_s, settings_.age_max_s);
  if (age_s <= late_s) return 1;
  return std::max(0.0, (settings_.age_max_s - age_s) / (settings_.age_max_s - late_s));
}

Command CommandOutlet::present(double now_s) {
  if (is_held_) return {};
  const double age_s = now_s - wanted_at_s_;
  if (age_s > settings_.age_max_s) {
    if (is_moving(wanted_)) ++aged_;
    wanted_ = {};
  }
  const DriveLimits& limits = vehicle_.limits;
  const double share = share_of(age_s);
  const double since_s = std::clamp(now_s - sent_at_s_, 0.0, kGainedOver_s);
  return {gained(sent_.speed_mps, share * wanted_.speed_mps, limits.acceleration_max_mps2 * since_s),
          wanted_.steering_rad,
          gained(sent_.turn_rate_rad_s, share * wanted_.turn_rate_rad_s,
                 limits.turn_acceleration_max_rad_s2 * since_s)};
}

}  // namespace aisle
