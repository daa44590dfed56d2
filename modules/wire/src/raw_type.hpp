#pragma once

#include <fastdds/dds/topic/TopicDataType.hpp>
#include <functional>
#include <string>

namespace aisle {

/// A type of messages that is a name and bytes: what a message of ROS is on the wire. Others describe their
/// types, too; nobody who matches by topic and name needs that.
class RawType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

  explicit RawType(const std::string& dds_type);

  bool serialize(void* data, Payload* payload) override;
  bool deserialize(Payload* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override;
};

}  // namespace aisle
