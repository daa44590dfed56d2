#pragma once
/// The records of an MCAP file (mcap.dev): opcode, length, content.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace aisle {

/// A file begins and ends with it.
inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

namespace mcap {

enum Opcode : std::uint8_t {
  kHeader = 1,
  kFooter = 2,
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kMessageIndex = 7,
  kChunkIndex = 8,
  kStatistics = 11,
  kDataEnd = 15
};

}  // namespace mcap

inline constexpr std::size_t kMcapRecordHead_bytes = 9;    ///< opcode and length
inline constexpr std::size_t kMcapMessageHead_bytes = 22;  ///< channel, sequence, log and publish time
inline constexpr std::size_t kMcapFooter_bytes = 20;

}  // namespace aisle
