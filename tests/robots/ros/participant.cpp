#include "participant.hpp"

#include <memory>
#include <stdexcept>

#include "byte_topic.hpp"

namespace robots {
namespace {

/// Participants find each other by unicast: every one tries the ports of the first 32 of this machine.
constexpr const char* kLoopbackOnly = R"(<CycloneDDS><Domain>
  <General>
    <Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces>
    <AllowMulticast>false</AllowMulticast>
    <MaxMessageSize>65500B</MaxMessageSize>
  </General>
  <Discovery>
    <ParticipantIndex>auto</ParticipantIndex>
    <MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>
    <Peers><Peer address="127.0.0.1"/></Peers>
    <LeaseDuration>%us</LeaseDuration>
  </Discovery>
  <Internal><SocketReceiveBufferSize min="default" max="4MB"/></Internal>
</Domain></CycloneDDS>)";

using Qos = std::unique_ptr<dds_qos_t, void (*)(dds_qos_t*)>;

dds_entity_t created(dds_entity_t entity, const std::string& what) {
  if (entity < 0) throw std::runtime_error(what + ": " + dds_strretcode(-entity));
  return entity;
}

Qos qos_of(Quality quality) {
  Qos qos(dds_create_qos(), dds_delete_qos);
  const bool reliable = quality != Quality::kSensor;
  dds_qset_reliability(qos.get(), reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, reliable ? 10 : 5);
  if (quality == Quality::kLatched) {
    dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, 1, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  }
  dds_qset_writer_data_lifecycle(qos.get(), false);
  return qos;
}

/// "sensor_msgs/msg/LaserScan" -> "sensor_msgs::msg::dds_::LaserScan_"
std::string dds_type(const std::string& type) {
  return type.substr(0, type.find('/')) + "::msg::dds_::" + type.substr(type.rfind('/') + 1) + "_";
}

dds_entity_t topic_of(dds_entity_t participant, const std::string& topic, const std::string& type) {
  return created(create_byte_topic(participant, "rt" + topic, dds_type(type)), "topic " + topic);
}

}  // namespace

Participant::Participant(unsigned domain, unsigned lease_s) {
  std::string settings = kLoopbackOnly;
  settings.replace(settings.find("%u"), 2, std::to_string(lease_s));
  // Refused if this process has already opened the domain, whose settings then remain.
  dds_create_domain(domain, settings.c_str());
  const Qos qos(dds_create_qos(), dds_delete_qos);
  dds_qset_userdata(qos.get(), "enclave=/;", 10);
  entity_ = created(dds_create_participant(domain, qos.get(), nullptr), "DDS participant");
}

Participant::~Participant() {
  dds_delete(entity_);
}

dds_entity_t Participant::writer(const std::string& topic, const std::string& type, Quality quality) const {
  return created(dds_create_writer(entity_, topic_of(entity_, topic, type), qos_of(quality).get(), nullptr),
                 topic);
}

dds_entity_t Participant::reader(const std::string& topic, const std::string& type, Quality quality) const {
  return created(dds_create_reader(entity_, topic_of(entity_, topic, type), qos_of(quality).get(), nullptr),
                 topic);
}

/// A reader that takes nothing in time loses messages, as with a real robot.
void write_bytes(dds_entity_t writer, const std::string& message) {
  dds_write(writer, &message);
}

std::optional<std::string> take_bytes(dds_entity_t reader) {
  std::string message;
  void* samples[] = {&message};
  dds_sample_info_t info;
  while (dds_take(reader, samples, &info, 1, 1) > 0) {
    if (info.valid_data) return message;
  }
  return std::nullopt;
}

bool wait_for_bytes(dds_entity_t reader, double timeout_s) {
  const dds_entity_t waitset = dds_create_waitset(dds_get_participant(reader));
  const dds_entity_t condition = dds_create_readcondition(reader, DDS_ANY_STATE);
  dds_waitset_attach(waitset, condition, 0);
  const bool there = dds_waitset_wait(waitset, nullptr, 0, static_cast<dds_duration_t>(1e9 * timeout_s)) > 0;
  dds_delete(condition);
  dds_delete(waitset);
  return there;
}

std::size_t matched_readers(dds_entity_t writer) {
  dds_publication_matched_status_t status{};
  dds_get_publication_matched_status(writer, &status);
  return status.current_count;
}

}  // namespace robots
