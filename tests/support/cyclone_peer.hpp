#pragma once
/// Another program of a ROS 2 network, as far as aisle can tell: Cyclone DDS, without any code of aisle. It
/// listens to and speaks to this machine alone.

#include <unistd.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "ros/byte_topic.hpp"
#include "waiting.hpp"

namespace aisle {

/// Tests that run at the same time are on networks of their own, or at least talk of other topics.
inline unsigned test_domain() {
  return 80 + static_cast<unsigned>(getpid()) % 20;
}
inline std::string test_topic(const std::string& name) {
  return "/test_" + std::to_string(getpid()) + "/" + name;
}

struct CycloneQuality {
  bool reliable = true;
  bool latched = false;  ///< transient local
  int depth = 10;
};

namespace cyclone {

inline dds_entity_t checked(dds_entity_t entity) {
  if (entity < 0) throw std::runtime_error(dds_strretcode(-entity));
  return entity;
}

/// Deleted with all that was made from it.
class Entity {
 public:
  explicit Entity(dds_entity_t entity) : entity_(checked(entity)) {}
  Entity(Entity&& other) noexcept : entity_(std::exchange(other.entity_, 0)) {}
  Entity& operator=(Entity&&) = delete;
  ~Entity() {
    if (entity_ > 0) dds_delete(entity_);
  }
  dds_entity_t get() const { return entity_; }

 private:
  dds_entity_t entity_;
};

struct QosDelete {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, QosDelete>;

inline Qos qos(const CycloneQuality& quality) {
  Qos made(dds_create_qos());
  dds_qset_history(made.get(), DDS_HISTORY_KEEP_LAST, quality.depth);
  dds_qset_reliability(made.get(), quality.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_durability(made.get(), quality.latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_durability_service(made.get(), 0, DDS_HISTORY_KEEP_LAST, quality.depth, -1, -1, -1);
  dds_qset_writer_data_lifecycle(made.get(), false);
  return made;
}

}  // namespace cyclone

class CycloneWriter {
 public:
  CycloneWriter(dds_entity_t participant, dds_entity_t topic, const CycloneQuality& quality)
      : writer_(dds_create_writer(participant, topic, cyclone::qos(quality).get(), nullptr)) {}

  /// @param message with its bytes of encapsulation
  void write(std::string_view message) {
    const std::string sample(message);
    cyclone::checked(dds_write(writer_.get(), &sample));
  }

  std::size_t readers() const {
    dds_publication_matched_status_t status;
    cyclone::checked(dds_get_publication_matched_status(writer_.get(), &status));
    return status.current_count;
  }

 private:
  cyclone::Entity writer_;
};

class CycloneReader {
 public:
  CycloneReader(dds_entity_t participant, dds_entity_t topic, const CycloneQuality& quality)
      : listener_(dds_create_listener(inbox_.get())) {
    dds_lset_data_available(listener_.get(), [](dds_entity_t reader, void* inbox) {
      take_all(reader, *static_cast<Inbox*>(inbox));
    });
    reader_ = std::make_unique<cyclone::Entity>(
        dds_create_reader(participant, topic, cyclone::qos(quality).get(), listener_.get()));
  }

  const Inbox& inbox() const { return *inbox_; }

  std::size_t writers() const {
    dds_subscription_matched_status_t status;
    cyclone::checked(dds_get_subscription_matched_status(reader_->get(), &status));
    return status.current_count;
  }

  /// What the last writer that could not be matched does not offer; DDS_INVALID_QOS_POLICY_ID: there was
  /// none.
  dds_qos_policy_id_t incompatible_policy() const {
    dds_requested_incompatible_qos_status_t status;
    cyclone::checked(dds_get_requested_incompatible_qos_status(reader_->get(), &status));
    return static_cast<dds_qos_policy_id_t>(status.last_policy_id);
  }

 private:
  static void take_all(dds_entity_t reader, Inbox& inbox) {
    std::string message;
    void* sample = &message;
    dds_sample_info_t info;
    while (dds_take(reader, &sample, &info, 1, 1) > 0) {
      if (info.valid_data) inbox.put(message);
    }
  }

  struct ListenerDelete {
    void operator()(dds_listener_t* listener) const { dds_delete_listener(listener); }
  };
  std::unique_ptr<Inbox> inbox_ = std::make_unique<Inbox>();
  std::unique_ptr<dds_listener_t, ListenerDelete> listener_;
  std::unique_ptr<cyclone::Entity> reader_;
};

class CyclonePeer {
 public:
  /// One at a time in a program and domain.
  /// @param lease_s after so long a silence, others take it for gone
  explicit CyclonePeer(unsigned domain = test_domain(), int lease_s = 10)
      : domain_(dds_create_domain(domain, configuration(lease_s).c_str())),
        participant_(dds_create_participant(domain, nullptr, nullptr)) {}

  /// @param topic, type  as DDS says them: "rt/scan", "sensor_msgs::msg::dds_::LaserScan_"
  CycloneWriter writer(const std::string& topic, const std::string& type,
                       const CycloneQuality& quality = {}) {
    return {participant_.get(), cyclone::checked(robots::create_byte_topic(participant_.get(), topic, type)),
            quality};
  }
  CycloneReader reader(const std::string& topic, const std::string& type,
                       const CycloneQuality& quality = {}) {
    return {participant_.get(), cyclone::checked(robots::create_byte_topic(participant_.get(), topic, type)),
            quality};
  }

  /// As if the program was killed: it neither says nor hears anything any more.
  void fall_silent() {
    cyclone::checked(dds_domain_set_deafmute(participant_.get(), true, true, DDS_INFINITY));
  }

 private:
  static std::string configuration(int lease_s) {
    return "<CycloneDDS><Domain Id=\"any\">"
           "<General><Interfaces><NetworkInterface address=\"127.0.0.1\"/></Interfaces>"
           "<AllowMulticast>false</AllowMulticast></General>"
           "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
           "<MaxAutoParticipantIndex>31</MaxAutoParticipantIndex>"
           "<Peers><Peer address=\"127.0.0.1\"/></Peers><LeaseDuration>" +
           std::to_string(lease_s) + "s</LeaseDuration></Discovery></Domain></CycloneDDS>";
  }

  cyclone::Entity domain_;
  cyclone::Entity participant_;
};

}  // namespace aisle
