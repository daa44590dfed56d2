#pragma once
/// metadata.yaml of a rosbag2 bag.

#include <cstdint>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/formats/sessions/session_storage.hpp"

namespace aisle {

struct SessionMetadata {
  struct TopicCount {
    SessionTopic topic;
    std::int64_t messages = 0;
  };

  SessionStorage storage = SessionStorage::kSqlite;
  std::string file_name;  ///< "drive_0.db3"
  ros::Stamp_ns first = 0;
  ros::Stamp_ns last = 0;
  std::int64_t messages = 0;
  std::vector<TopicCount> topics;
};

/// Version 5 of the format: ROS 2 Humble writes it, and all later releases read it.
std::string metadata_yaml(const SessionMetadata& metadata);

/// The quality of service of a topic as in metadata.yaml and the database.
std::string quality_of_service(bool latched);

/// Whether such a text describes a latched topic.
bool is_latched(const std::string& quality);

/// The one file of a bag.
struct SessionFile {
  SessionStorage storage = SessionStorage::kSqlite;
  std::string name;  ///< beside metadata.yaml
  /// As metadata.yaml says; 0: unknown, as in a recording that was killed.
  std::int64_t messages = 0;
  double duration_s = 0;
};

/// For bags in another layout, the problem says which layout is read.
Result<SessionFile> parse_session_file(const std::string& text, const std::string& name);

}  // namespace aisle
