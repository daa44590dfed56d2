#include "participant.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fmt/format.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <string_view>

#include "raw_type.hpp"
#include "ros_names.hpp"

namespace aisle {
namespace {

namespace fdds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr std::uint32_t kSendBufferBytes = 1U << 20U;
constexpr std::uint32_t kReceiveBufferBytes = 2U << 20U;
/// How many programs a machine may have on the network: each has two ports of its own.
constexpr std::uint32_t kParticipantsOfMachine = 32;
constexpr const char* kMulticastAddress = "239.255.0.1";
/// What every participant of ROS 2 says about itself.
constexpr std::string_view kUserData = "enclave=/;";

/// Fast DDS as this program uses it, set up once: it is silent, and messages between two participants of one
/// program go the same way as all others, not through each other's threads.
std::shared_ptr<fdds::DomainParticipantFactory> fast_dds() {
  static const auto factory = [] {
    fdds::Log::ClearConsumers();
    auto opened = fdds::DomainParticipantFactory::get_shared_instance();
    // Fast DDS takes settings from a file in the working directory, too: now, not after what is set here.
    opened->load_profiles();
    eprosima::fastrtps::LibrarySettingsAttributes library;
    library.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(library);
    return opened;
  }();
  return factory;
}

/// @param port 0: of a peer, all ports at which its programs may listen
rtps::Locator_t locator_of(const std::string& address, std::uint32_t port = 0) {
  rtps::Locator_t locator;
  rtps::IPLocator::setIPv4(locator, address);
  locator.port = port;
  return locator;
}

/// Of the ports at which others look for participants, the first two that are free. By itself, Fast DDS goes
/// two further with each wire that a program opens, in the end to where nobody looks.
void listen(fdds::WireProtocolConfigQos& protocol, const WireSettings& settings) {
  const rtps::PortParameters& ports = protocol.port;
  const std::uint32_t first = ports.portBase + ports.domainIDGain * settings.domain;
  // With a list that is not empty, it does not listen to multicast.
  protocol.builtin.metatrafficMulticastLocatorList.clear();
  protocol.builtin.metatrafficUnicastLocatorList.push_back(
      locator_of(settings.interface_address, first + ports.offsetd1));
  protocol.default_unicast_locator_list.push_back(
      locator_of(settings.interface_address, first + ports.offsetd3));
}

void look_for_others(fdds::WireProtocolConfigQos& protocol, const WireSettings& settings) {
  rtps::LocatorList_t& places = protocol.builtin.initialPeersList;
  for (const std::string& peer : settings.peers) places.push_back(locator_of(peer));
  if (settings.announces_by_multicast)
    places.push_back(locator_of(kMulticastAddress, protocol.port.getMulticastPort(settings.domain)));
}

fdds::DomainParticipantQos participant_qos(const WireSettings& settings) {
  const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {settings.interface_address};
  udp->maxInitialPeersRange = kParticipantsOfMachine;
  udp->sendBufferSize = kSendBufferBytes;
  udp->receiveBufferSize = kReceiveBufferBytes;

  fdds::DomainParticipantQos qos;
  qos.name("aisle");
  qos.user_data().setValue({kUserData.begin(), kUserData.end()});
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);

  listen(qos.wire_protocol(), settings);
  look_for_others(qos.wire_protocol(), settings);
  auto& discovery = qos.wire_protocol().builtin;
  discovery.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  discovery.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  return qos;
}

}  // namespace

void TopicRelease::operator()(fdds::Topic* topic) const {
  topic->get_participant()->delete_topic(topic);
}

Result<std::shared_ptr<Participant>> Participant::open(const WireSettings& settings) {
  const std::shared_ptr<Participant> opened(new Participant);
  opened->factory_ = fast_dds();
  opened->participant_ = opened->factory_->create_participant(settings.domain, participant_qos(settings),
                                                              &opened->table_, fdds::StatusMask::none());
  if (opened->participant_ == nullptr)
    return Problem{
        {.key = "interface"},
        fmt::format("no port of domain {} can be opened on {}", settings.domain, settings.interface_address)};
  opened->publisher_ = opened->participant_->create_publisher(fdds::PUBLISHER_QOS_DEFAULT);
  opened->subscriber_ = opened->participant_->create_subscriber(fdds::SUBSCRIBER_QOS_DEFAULT);
  return opened;
}

Participant::~Participant() {
  if (participant_ == nullptr) return;
  participant_->delete_contained_entities();
  factory_->delete_participant(participant_);
}

Result<TopicUse> Participant::use_topic(const std::string& topic, const std::string& type) {
  if (!is_ros_topic(topic))
    return Problem{{.key = topic}, "is not the full name of a topic, such as /robot/scan"};
  if (!is_ros_type(type))
    return Problem{{.key = topic}, fmt::format("'{}' is not a type such as sensor_msgs/msg/LaserScan", type)};
  const std::string name = dds_topic(topic), type_name = dds_type(type);
  const std::lock_guard lock(topics_mutex_);
  TopicUse used(participant_->find_topic(name, {0, 0}));
  if (!used) {
    if (participant_->find_type(type_name).empty())
      participant_->register_type(fdds::TypeSupport(new RawType(type_name)));
    used.reset(participant_->create_topic(name, type_name, fdds::TOPIC_QOS_DEFAULT));
  }
  if (!used) return Problem{{.key = topic}, "cannot be opened"};
  if (used->get_type_name() != type_name)
    return Problem{{.key = topic},
                   fmt::format("is in use as {}, so not as {}", ros_type(used->get_type_name()), type)};
  return used;
}

}  // namespace aisle
