#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "ros/messages.hpp"
#include "ros/participant.hpp"

namespace robots {

/// What happens to the messages of a topic on their way. Times are of the robot's clock.
struct Fault {
  double lost_share = 0;      ///< 1: the topic is frozen
  double delay_s = 0;         ///< of every message
  double delay_spread_s = 0;  ///< and up to so much more, so that messages overtake each other
  int copies = 1;
  std::function<std::string(const std::string&)> rewrite;  ///< of the bytes; empty: as they are
};

Fault frozen();
Fault delayed(double delay_s);
Fault rewritten(std::function<std::string(const std::string&)> rewrite);
/// Of images: new stamps, but the pixels stay those of the first.
Fault showing_the_same();
/// Of messages that begin with their stamp, as scans, odometry and /clock do.
Fault stamped_later(double shift_s);

/// Stands between a robot in one domain and whoever drives it in another, and does to the messages what it is
/// told. The robot's odometry, as the robot sent it, says how it moves.
class FaultRelay {
 public:
  /// @param lease_s  for which a driver believes what is on its side to be there, after it has gone
  FaultRelay(unsigned robots_domain, unsigned drivers_domain, unsigned lease_s = 10);
  ~FaultRelay();
  FaultRelay(const FaultRelay&) = delete;
  FaultRelay& operator=(const FaultRelay&) = delete;

  /// From now on; what a topic had before is over. `Fault{}`: the topic is well again.
  void set(const std::string& topic, const Fault& fault);
  /// The same, when so much of the robot's time will have passed.
  void set_in(double from_now_s, const std::string& topic, const Fault& fault);
  /// All topics are well again, and nothing is due any more.
  void heal();

  /// By the robot's clock, of its newest odometry.
  double robot_time_s() const;
  /// When its wheels last turned, by its clock.
  double last_motion_s() const;
  double speed_mps() const;
  Vector3 position() const;  ///< by its odometry
  double driven_m() const;
  /// Waits for what the robot does, or the test sees. @return whether it came about in half a minute at least
  bool wait_until(const std::function<bool(const FaultRelay&)>& is_so) const;

 private:
  struct Lane {
    std::string topic;
    dds_entity_t reader;
    dds_entity_t writer;
  };
  /// What is to be done when the robot's clock is so far.
  using Due = std::multimap<double, std::function<void()>>;

  void add_lane(const Participant& from, const Participant& to, const std::string& topic,
                const std::string& type, Quality quality);
  void run();
  void pass_on(const Lane& lane, const std::string& bytes);
  void watch(const std::string& bytes);
  void do_what_is_due();

  Participant robots_side_, drivers_side_;
  std::vector<Lane> lanes_;
  dds_entity_t waitset_;

  // Guarded by the mutex.
  mutable std::recursive_mutex mutex_;
  mutable std::condition_variable_any moved_;
  std::map<std::string, Fault> faults_;
  Due due_;
  std::mt19937_64 random_{1};
  std::optional<Odometry> newest_;
  double last_motion_s_ = 0;
  double driven_m_ = 0;
  bool is_over_ = false;

  std::thread thread_;
};

}  // namespace robots
