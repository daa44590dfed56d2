#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/bags/bag_message.hpp"
#include "aisle/formats/sessions/ros_time.hpp"

namespace aisle {

struct BagTopic {
  std::string name;           ///< as recorded: "/scan", "scan"
  std::string type;           ///< "sensor_msgs/msg/LaserScan", also in bags of ROS 1
  std::int64_t messages = 0;  ///< how many are recorded
  bool latched = false;       ///< late subscribers still get the last message
  BagEncoding encoding = BagEncoding::kCdr;
};

/// Whether a file or a folder is a bag by its first bytes or by its name; it may still be damaged.
bool is_bag(const std::filesystem::path& path);

/// Reads a bag of ROS 2 (SQLite or MCAP) or ROS 1 message by message: a single file, or a folder with one or
/// several. Never changes a file of the bag. What is cut off or damaged is left out with a warning; the
/// messages before it are read. docs/formats/bags.md says what is read.
class BagReader {
 public:
  struct Message {
    std::size_t topic = 0;        ///< index in topics()
    ros::Stamp_ns log_stamp = 0;  ///< when it was recorded
    long number = 0;              ///< in the bag; the first message is 1
    std::string_view bytes;       ///< in the topic's encoding; valid until the next call
  };

  static Result<BagReader> open(const std::filesystem::path& path);

  BagReader(BagReader&&) noexcept;
  BagReader& operator=(BagReader&&) noexcept;
  ~BagReader();

  const std::vector<BagTopic>& topics() const;

  /// Begins again before the first message, with these topics only (indices in topics()). Other messages are
  /// neither copied nor decoded. At first all topics are wanted.
  void want(const std::vector<std::size_t>& topics);

  /// The next message in the order of recording; the files of a split bag are merged by log stamp.
  /// @return nullopt after the last
  Result<std::optional<Message>> next();

  /// What was left out so far, each once.
  const Problems& warnings() const;

 private:
  class Source;

  explicit BagReader(std::unique_ptr<Source> source);

  std::unique_ptr<Source> source_;
};

}  // namespace aisle
