#include "fault_relay.hpp"

#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

namespace robots {
namespace {

constexpr double kStanding_mps = 0.01;
constexpr double kStanding_radps = 0.03;
constexpr dds_duration_t kLook = DDS_MSECS(2);

bool turns_its_wheels(const Twist& twist) {
  return std::abs(twist.linear.x) > kStanding_mps || std::abs(twist.angular.z) > kStanding_radps;
}

}  // namespace

Fault frozen() {
  Fault fault;
  fault.lost_share = 1;
  return fault;
}

Fault delayed(double delay_s) {
  Fault fault;
  fault.delay_s = delay_s;
  return fault;
}

Fault rewritten(std::function<std::string(const std::string&)> rewrite) {
  Fault fault;
  fault.rewrite = std::move(rewrite);
  return fault;
}

Fault showing_the_same() {
  auto shown = std::make_shared<std::optional<Image>>();
  return rewritten([shown](const std::string& bytes) {
    auto image = from_cdr<Image>(bytes).value();
    if (!*shown) *shown = image;
    image.data = (*shown)->data;
    return to_cdr(image);
  });
}

Fault stamped_later(double shift_s) {
  return rewritten([shift_s](const std::string& bytes) {
    constexpr std::size_t kStampAt = 4;  // after the encapsulation
    std::string shifted = bytes;
    std::int32_t seconds = 0;
    std::memcpy(&seconds, shifted.data() + kStampAt, sizeof seconds);
    seconds += static_cast<std::int32_t>(shift_s);
    std::memcpy(shifted.data() + kStampAt, &seconds, sizeof seconds);
    return shifted;
  });
}

FaultRelay::FaultRelay(unsigned robots_domain, unsigned drivers_domain, unsigned lease_s)
    : robots_side_(robots_domain),
      drivers_side_(drivers_domain, lease_s),
      waitset_(dds_create_waitset(DDS_CYCLONEDDS_HANDLE)) {
  add_lane(robots_side_, drivers_side_, "/clock", Clock::kType, Quality::kSensor);
  add_lane(robots_side_, drivers_side_, "/odom", Odometry::kType, Quality::kDefault);
  add_lane(robots_side_, drivers_side_, "/scan", LaserScan::kType, Quality::kSensor);
  add_lane(robots_side_, drivers_side_, "/camera/image_raw", Image::kType, Quality::kSensor);
  add_lane(robots_side_, drivers_side_, "/camera/camera_info", CameraInfo::kType, Quality::kSensor);
  add_lane(robots_side_, drivers_side_, "/bumper", Bool::kType, Quality::kDefault);
  add_lane(robots_side_, drivers_side_, "/tf_static", TFMessage::kType, Quality::kLatched);
  add_lane(drivers_side_, robots_side_, "/cmd_vel", Twist::kType, Quality::kDefault);
  thread_ = std::thread([this] { run(); });
}

FaultRelay::~FaultRelay() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  thread_.join();
  dds_delete(waitset_);
}

void FaultRelay::add_lane(const Participant& from, const Participant& to, const std::string& topic,
                          const std::string& type, Quality quality) {
  const Lane lane{topic, from.reader(topic, type, quality), to.writer(topic, type, quality)};
  dds_waitset_attach(waitset_, dds_create_readcondition(lane.reader, DDS_ANY_STATE), 0);
  lanes_.push_back(lane);
}

void FaultRelay::set(const std::string& topic, const Fault& fault) {
  const std::lock_guard lock(mutex_);
  faults_[topic] = fault;
}

void FaultRelay::set_in(double from_now_s, const std::string& topic, const Fault& fault) {
  const std::lock_guard lock(mutex_);
  due_.emplace(robot_time_s() + from_now_s, [this, topic, fault] { set(topic, fault); });
}

void FaultRelay::heal() {
  const std::lock_guard lock(mutex_);
  faults_.clear();
  due_.clear();
}

void FaultRelay::run() {
  for (;;) {
    dds_waitset_wait(waitset_, nullptr, 0, kLook);
    const std::lock_guard lock(mutex_);
    if (is_over_) return;
    for (const Lane& lane : lanes_) {
      while (const auto bytes = take_bytes(lane.reader)) {
        if (lane.topic == "/odom") watch(*bytes);
        pass_on(lane, *bytes);
      }
    }
    do_what_is_due();
  }
}

void FaultRelay::pass_on(const Lane& lane, const std::string& bytes) {
  const Fault& fault = faults_[lane.topic];
  std::uniform_real_distribution<double> any;
  if (any(random_) < fault.lost_share) return;
  const std::string message = fault.rewrite ? fault.rewrite(bytes) : bytes;
  for (int i = 0; i < fault.copies; ++i) {
    const double delay_s = fault.delay_s + fault.delay_spread_s * any(random_);
    if (delay_s <= 0) {
      write_bytes(lane.writer, message);
    } else {
      due_.emplace(robot_time_s() + delay_s,
                   [writer = lane.writer, message] { write_bytes(writer, message); });
    }
  }
}

void FaultRelay::watch(const std::string& bytes) {
  auto odometry = from_cdr<Odometry>(bytes);
  if (!odometry) return;
  if (newest_) {
    const Vector3 &before = newest_->pose.position, &now = odometry->pose.position;
    driven_m_ += std::hypot(now.x - before.x, now.y - before.y);
  }
  if (newest_ && odometry->header.stamp.seconds() < robot_time_s()) last_motion_s_ = 0;  // another robot
  newest_ = std::move(odometry);
  if (turns_its_wheels(newest_->twist)) last_motion_s_ = newest_->header.stamp.seconds();
  moved_.notify_all();
}

void FaultRelay::do_what_is_due() {
  const double now_s = robot_time_s();
  while (!due_.empty() && due_.begin()->first <= now_s) due_.extract(due_.begin()).mapped()();
}

double FaultRelay::robot_time_s() const {
  const std::lock_guard lock(mutex_);
  return newest_ ? newest_->header.stamp.seconds() : 0;
}

double FaultRelay::last_motion_s() const {
  const std::lock_guard lock(mutex_);
  return last_motion_s_;
}

double FaultRelay::speed_mps() const {
  const std::lock_guard lock(mutex_);
  return newest_ ? newest_->twist.linear.x : 0;
}

Vector3 FaultRelay::position() const {
  const std::lock_guard lock(mutex_);
  return newest_ ? newest_->pose.position : Vector3{};
}

double FaultRelay::driven_m() const {
  const std::lock_guard lock(mutex_);
  return driven_m_;
}

bool FaultRelay::wait_until(const std::function<bool(const FaultRelay&)>& is_so) const {
  constexpr int kTries = 1500;
  constexpr std::chrono::milliseconds kLookAgain(20);  // a robot that hangs wakes nobody
  std::unique_lock lock(mutex_);
  for (int i = 0; i < kTries && !is_so(*this); ++i) moved_.wait_for(lock, kLookAgain);
  return is_so(*this);
}

}  // namespace robots
