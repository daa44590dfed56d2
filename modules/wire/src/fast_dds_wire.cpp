#include <fmt/format.h>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "aisle/wire/wire.hpp"
#include "discovered_endpoints.hpp"
#include "network_addresses.hpp"
#include "raw_type.hpp"
#include "ros_names.hpp"

namespace aisle {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr unsigned kDomainMax = 101;  // the ports of a larger one are given to other programs by Linux
constexpr std::uint32_t kReceiveBuffer_bytes = 2U << 20;  // for images; the system may grant less
constexpr unsigned kPeersAtAnAddress = 32;                // programs that are looked for at one address
constexpr const char* kMulticast = "239.255.0.1";

unsigned multicast_port(unsigned domain) {
  return 7400 + 250 * domain;  // the ports that RTPS prescribes
}

/// Everything on one interface, over UDP alone: no shared memory, which a killed program would leave behind.
dds::DomainParticipantQos participant_qos(const WireSettings& settings, const std::string& interface_address,
                                          const std::vector<std::string>& peers) {
  dds::DomainParticipantQos qos;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {interface_address};
  udp->maxInitialPeersRange = kPeersAtAnAddress;
  udp->receiveBufferSize = kReceiveBuffer_bytes;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  auto& builtin = qos.wire_protocol().builtin;
  builtin.metatrafficMulticastLocatorList.clear();
  builtin.metatrafficUnicastLocatorList.push_back(rtps::Locator_t());
  for (const std::string& address : peers) {
    rtps::Locator_t peer;
    rtps::IPLocator::setIPv4(peer, address);
    builtin.initialPeersList.push_back(peer);
  }
  if (settings.announces_by_multicast) {
    rtps::Locator_t group;
    rtps::IPLocator::setIPv4(group, kMulticast);
    group.port = multicast_port(settings.domain);
    builtin.initialPeersList.push_back(group);
  }
  return qos;
}

/// Sets what reader and writer have alike.
template <class Qos>
void set_quality(Qos& qos, WireQuality quality) {
  const bool is_latched = quality == WireQuality::kLatched;
  qos.reliability().kind =
      quality == WireQuality::kSensor ? dds::BEST_EFFORT_RELIABILITY_QOS : dds::RELIABLE_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = {0, 100'000'000};
  qos.durability().kind = is_latched ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = quality == WireQuality::kCommand ? 1 : quality == WireQuality::kSensor ? 5 : 10;
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
}

/// Gives what arrives to a sink, until it is closed.
class Listener final : public dds::DataReaderListener {
 public:
  explicit Listener(Wire::Sink sink) : sink_(std::move(sink)) {}

  void on_data_available(dds::DataReader* reader) override {
    const std::lock_guard lock(mutex_);
    dds::SampleInfo info;
    while (sink_ && reader->take_next_sample(&bytes_, &info) == ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) sink_(bytes_);
    }
  }

  /// The sink is no longer called once this has returned.
  void close() {
    const std::lock_guard lock(mutex_);
    sink_ = nullptr;
  }

 private:
  std::mutex mutex_;
  Wire::Sink sink_;
  std::string bytes_;
};

class FastDdsSubscription final : public WireSubscription {
 public:
  FastDdsSubscription(dds::Subscriber& subscriber, dds::Topic& topic, WireQuality quality, Wire::Sink sink)
      : subscriber_(subscriber), listener_(std::move(sink)) {
    dds::DataReaderQos qos;
    set_quality(qos, quality);
    reader_ = subscriber.create_datareader(&topic, qos, &listener_);
  }
  ~FastDdsSubscription() override {
    listener_.close();
    if (reader_ != nullptr) subscriber_.delete_datareader(reader_);
  }
  FastDdsSubscription(const FastDdsSubscription&) = delete;
  FastDdsSubscription& operator=(const FastDdsSubscription&) = delete;

  bool is_open() const { return reader_ != nullptr; }

  std::size_t publishers() const override {
    dds::SubscriptionMatchedStatus status;
    reader_->get_subscription_matched_status(status);
    return static_cast<std::size_t>(std::max(0, status.current_count));
  }

  std::string incompatible_quality() const override {
    dds::RequestedIncompatibleQosStatus status;
    reader_->get_requested_incompatible_qos_status(status);
    if (status.total_count == 0) return {};
    switch (status.last_policy_id) {
      case dds::RELIABILITY_QOS_POLICY_ID:
        return "reliability";
      case dds::DURABILITY_QOS_POLICY_ID:
        return "durability";
      default:
        return fmt::format("policy {}", static_cast<int>(status.last_policy_id));
    }
  }

 private:
  dds::Subscriber& subscriber_;
  Listener listener_;
  dds::DataReader* reader_ = nullptr;
};

class FastDdsPublisher final : public WirePublisher {
 public:
  FastDdsPublisher(dds::Publisher& publisher, dds::Topic& topic, WireQuality quality)
      : publisher_(publisher) {
    dds::DataWriterQos qos;
    set_quality(qos, quality);
    qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
    writer_ = publisher.create_datawriter(&topic, qos);
  }
  ~FastDdsPublisher() override {
    if (writer_ != nullptr) publisher_.delete_datawriter(writer_);
  }
  FastDdsPublisher(const FastDdsPublisher&) = delete;
  FastDdsPublisher& operator=(const FastDdsPublisher&) = delete;

  bool is_open() const { return writer_ != nullptr; }

  void publish(std::string_view message) override {
    const std::lock_guard lock(mutex_);
    bytes_.assign(message);
    writer_->write(&bytes_);
  }

  std::size_t subscribers() const override {
    dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return static_cast<std::size_t>(std::max(0, status.current_count));
  }

 private:
  dds::Publisher& publisher_;
  dds::DataWriter* writer_ = nullptr;
  std::mutex mutex_;
  std::string bytes_;
};

class FastDdsWire final : public Wire {
 public:
  FastDdsWire(unsigned domain, const dds::DomainParticipantQos& qos)
      : participant_(dds::DomainParticipantFactory::get_instance()->create_participant(
            domain, qos, &endpoints_, dds::StatusMask::none())) {
    if (participant_ == nullptr) return;
    subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  }
  ~FastDdsWire() override {
    if (participant_ == nullptr) return;
    participant_->set_listener(nullptr);
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  FastDdsWire(const FastDdsWire&) = delete;
  FastDdsWire& operator=(const FastDdsWire&) = delete;

  bool is_open() const { return subscriber_ != nullptr && publisher_ != nullptr; }

  Result<std::unique_ptr<WireSubscription>> subscribe(const std::string& topic, const std::string& type,
                                                      WireQuality quality, Sink sink) override {
    const auto known = topic_of(topic, type);
    if (!known) return known.problems();
    auto subscription =
        std::make_unique<FastDdsSubscription>(*subscriber_, **known, quality, std::move(sink));
    if (!subscription->is_open()) return Problem{{topic}, "cannot be subscribed"};
    return std::unique_ptr<WireSubscription>(std::move(subscription));
  }

  Result<std::unique_ptr<WirePublisher>> advertise(const std::string& topic, const std::string& type,
                                                   WireQuality quality) override {
    const auto known = topic_of(topic, type);
    if (!known) return known.problems();
    auto publisher = std::make_unique<FastDdsPublisher>(*publisher_, **known, quality);
    if (!publisher->is_open()) return Problem{{topic}, "cannot be published"};
    return std::unique_ptr<WirePublisher>(std::move(publisher));
  }

  std::vector<WireEndpoint> endpoints() const override { return endpoints_.sorted(); }

 private:
  Result<dds::Topic*> topic_of(const std::string& name, const std::string& type) {
    const std::lock_guard lock(mutex_);
    if (const auto known = topics_.find(name); known != topics_.end()) {
      if (known->second->get_type_name() == dds_type(type)) return known->second;
      return Problem{
          {name}, fmt::format("is in use as {}, not as {}", ros_type(known->second->get_type_name()), type)};
    }
    dds::TypeSupport(new RawType(dds_type(type))).register_type(participant_);  // NOLINT: it takes ownership
    dds::Topic* const topic =
        participant_->create_topic(dds_topic(name), dds_type(type), dds::TOPIC_QOS_DEFAULT);
    if (topic == nullptr) return Problem{{name}, "is no topic's name"};
    topics_[name] = topic;
    return topic;
  }

  DiscoveredEndpoints endpoints_;  ///< before the participant, which fills it
  dds::DomainParticipant* participant_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  std::mutex mutex_;
  std::map<std::string, dds::Topic*> topics_;
};

}  // namespace

Result<std::unique_ptr<Wire>> Wire::open(const WireSettings& settings) {
  Problems problems;
  if (settings.domain > kDomainMax)
    problems.push_back({{"domain"}, fmt::format("{} is outside 0 .. {}", settings.domain, kDomainMax)});
  const auto interface_address = address_of(settings.interface_address);
  const std::vector<std::string> own = own_addresses();
  if (!interface_address || std::find(own.begin(), own.end(), *interface_address) == own.end())
    problems.push_back({{"interface"},
                        fmt::format("'{}' is no address of this machine, which has {}",
                                    settings.interface_address, fmt::join(own, ", "))});
  std::vector<std::string> peers;
  for (const std::string& peer : settings.peers) {
    if (const auto address = address_of(peer)) {
      peers.push_back(*address);
    } else {
      problems.push_back({{"peers"}, fmt::format("'{}' is no address and no known host", peer)});
    }
  }
  if (!problems.empty()) return problems;
  dds::Log::ClearConsumers();  // what goes wrong is said by aisle
  auto wire =
      std::make_unique<FastDdsWire>(settings.domain, participant_qos(settings, *interface_address, peers));
  if (!wire->is_open())
    return Problem{{"wire"},
                   fmt::format("cannot take part in domain {} at {}: are its ports in use?", settings.domain,
                               *interface_address)};
  return std::unique_ptr<Wire>(std::move(wire));
}

}  // namespace aisle
