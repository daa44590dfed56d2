#include "raw_type.hpp"

#include <cstring>

namespace aisle {
namespace {

constexpr std::uint32_t kUsual_bytes = 256;  // the memory for a message grows where it is larger
constexpr std::uint32_t kMost_bytes = 64U << 20;

std::string& bytes_of(void* data) {
  return *static_cast<std::string*>(data);
}

}  // namespace

RawType::RawType(const std::string& dds_type) {
  setName(dds_type.c_str());
  m_typeSize = kUsual_bytes;
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool RawType::serialize(void* data, Payload* payload) {
  const std::string& bytes = bytes_of(data);
  if (bytes.size() > payload->max_size) return false;
  std::memcpy(payload->data, bytes.data(), bytes.size());
  payload->length = static_cast<std::uint32_t>(bytes.size());
  payload->encapsulation = CDR_LE;
  return true;
}

bool RawType::deserialize(Payload* payload, void* data) {
  if (payload->length > kMost_bytes) return false;
  bytes_of(data).assign(reinterpret_cast<const char*>(payload->data), payload->length);  // NOLINT: bytes
  return true;
}

std::function<std::uint32_t()> RawType::getSerializedSizeProvider(void* data) {
  return [data] { return static_cast<std::uint32_t>(bytes_of(data).size()); };
}

void* RawType::createData() {
  return new std::string;  // NOLINT: Fast DDS owns it until deleteData
}

void RawType::deleteData(void* data) {
  delete static_cast<std::string*>(data);  // NOLINT: from createData
}

bool RawType::getKey(void* /*data*/, eprosima::fastrtps::rtps::InstanceHandle_t* /*handle*/,
                     bool /*force_md5*/) {
  return false;
}

}  // namespace aisle
