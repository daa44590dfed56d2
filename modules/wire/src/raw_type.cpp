#include "raw_type.hpp"

#include <algorithm>
#include <string_view>

namespace aisle {
namespace {

constexpr std::uint32_t kEncapsulationBytes = 4;
constexpr std::uint32_t kMessageBytesMax = 64U << 20U;
/// What Fast DDS reserves before the first message; larger ones make it reserve more.
constexpr std::uint32_t kMessageBytesExpected = 64;

}  // namespace

RawType::RawType(const std::string& name) {
  setName(name.c_str());
  m_typeSize = kMessageBytesExpected;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool RawType::serialize(void* message, Payload* payload) {
  const auto& bytes = *static_cast<const std::string_view*>(message);
  if (bytes.size() > payload->max_size) return false;
  std::copy(bytes.begin(), bytes.end(), payload->data);
  payload->length = static_cast<std::uint32_t>(bytes.size());
  payload->encapsulation = CDR_LE;
  return true;
}

bool RawType::deserialize(Payload* payload, void* message) {
  if (payload->length < kEncapsulationBytes || payload->length > kMessageBytesMax) return false;
  static_cast<std::string*>(message)->assign(reinterpret_cast<const char*>(payload->data), payload->length);
  return true;
}

std::function<std::uint32_t()> RawType::getSerializedSizeProvider(void* message) {
  return
      [message] { return static_cast<std::uint32_t>(static_cast<const std::string_view*>(message)->size()); };
}

void* RawType::createData() {
  return new std::string;
}

void RawType::deleteData(void* message) {
  delete static_cast<std::string*>(message);
}

bool RawType::getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) {
  return false;
}

}  // namespace aisle
