#pragma once

#include <fastdds/dds/topic/TopicDataType.hpp>
#include <string>

namespace aisle {

/// A type that is a name and bytes. Fast DDS writes a std::string_view and reads into a std::string, both
/// with the bytes of encapsulation.
class RawType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

  /// @param name as DDS says it
  explicit RawType(const std::string& name);

  bool serialize(void* message, Payload* payload) override;
  /// @return false, so that the message is dropped, if it is without encapsulation or larger than 64 MiB
  bool deserialize(Payload* payload, void* message) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* message) override;
  void* createData() override;
  void deleteData(void* message) override;
  bool getKey(void* message, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override;
};

}  // namespace aisle
