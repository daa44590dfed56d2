#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"

namespace aisle {

/// Which part of a ROS 2 network a program takes part in.
struct WireSettings {
  unsigned domain = 0;                          ///< ROS_DOMAIN_ID, 0 to 101
  std::string interface_address = "127.0.0.1";  ///< the only address that is listened on
  std::vector<std::string> peers{"127.0.0.1"};  ///< addresses at which others are looked for
  bool announces_by_multicast = false;          ///< so that those find it that look for no peers
};

/// What a subscription asks for, or a publisher offers: quality of service, as the ROS 2 profiles have it.
enum class WireQuality {
  kSensor,   ///< best effort, volatile, the last 5: what subscriptions ask for, but those to latched topics
  kDefault,  ///< reliable, volatile, the last 10
  kCommand,  ///< reliable, volatile, the last 1
  kLatched,  ///< reliable, transient local, the last 10: /map, /tf_static
};

/// A publisher or subscriber of somebody else, as discovered.
struct WireEndpoint {
  enum class Kind { kPublisher, kSubscriber };
  Kind kind = Kind::kPublisher;
  std::string topic;  ///< as ROS says it: "/scan"
  std::string type;   ///< as ROS says it: "sensor_msgs/msg/LaserScan"
  bool reliable = false;
  bool latched = false;     ///< transient local
  std::string participant;  ///< tells programs apart; the same for all endpoints of one

  friend bool operator==(const WireEndpoint&, const WireEndpoint&) = default;
};

/// Keeps a topic subscribed, even after the wire that made it; its destruction returns once the sink is no
/// longer called.
class WireSubscription {
 public:
  virtual ~WireSubscription() = default;

  /// How many publishers are matched. A match promises nothing: only data do.
  virtual std::size_t publishers() const = 0;
  /// What publishers of this topic and type lack that cannot be matched: "reliability", "durability", or
  /// "durability, reliability"; empty: there is none.
  virtual std::string incompatible_quality() const = 0;
};

/// Publishes on one topic, even after the wire that made it.
class WirePublisher {
 public:
  virtual ~WirePublisher() = default;

  /// @param message CDR with its four bytes of encapsulation (cdr.hpp). Never blocks for longer than 100 ms.
  virtual void publish(std::string_view message) = 0;
  /// How many subscribers are matched.
  virtual std::size_t subscribers() const = 0;
};

/// A participant of a ROS 2 network (DDS, RTPS over UDP), without ROS 2. All calls are thread-safe.
class Wire {
 public:
  /// Takes a message's bytes as they came: with encapsulation, filled up to a multiple of four bytes, at most
  /// 64 MiB. Called by a thread of the wire, one message of a subscription at a time. Must not block, must
  /// not throw, and must not end a subscription.
  using Sink = std::function<void(std::string_view message)>;

  /// @return all problems, with the keys "domain", "interface" and "peers": the domain is out of range, the
  ///         interface's address is none of this machine's, a peer is no address or cannot be reached from it
  static Result<std::unique_ptr<Wire>> open(const WireSettings& settings);

  virtual ~Wire() = default;

  /// @param topic as ROS says it: "/scan"
  /// @param type as ROS says it: "sensor_msgs/msg/LaserScan"
  /// @return problems if this topic is already in use here with another type
  virtual Result<std::unique_ptr<WireSubscription>> subscribe(const std::string& topic,
                                                              const std::string& type, WireQuality quality,
                                                              Sink sink) = 0;
  virtual Result<std::unique_ptr<WirePublisher>> advertise(const std::string& topic, const std::string& type,
                                                           WireQuality quality) = 0;

  /// What others publish and subscribe at present, sorted by topic, type and kind; our own are not in it.
  /// A killed program stays in it until its lease ends (10 to 20 s). So does one of Cyclone DDS that ends,
  /// and what it stops to publish or subscribe before stays in it with it: its goodbye is not understood.
  virtual std::vector<WireEndpoint> endpoints() const = 0;
};

}  // namespace aisle
