#include "sessions/session_metadata.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr int kMetadataVersion = 5;

/// Text in double quotes; YAML understands all of JSON's escapes.
std::string json_quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string topic_yaml(const SessionMetadata::TopicCount& count) {
  return fmt::format(
      "    - topic_metadata:\n"
      "        name: {}\n"
      "        type: {}\n"
      "        serialization_format: cdr\n"
      "        offered_qos_profiles: {}\n"
      "      message_count: {}\n",
      count.topic.name, count.topic.type, json_quoted(quality_of_service(count.topic.latched)),
      count.messages);
}

std::optional<std::string> scalar(const YAML::Node& map, const char* key) {
  const YAML::Node value = map[key];
  if (!value || !value.IsScalar()) return std::nullopt;
  return value.Scalar();
}

/// 0 for all that is not a positive whole number.
std::int64_t whole_number(const YAML::Node& value) {
  return value && value.IsScalar() ? std::max<std::int64_t>(0, value.as<std::int64_t>(0)) : 0;
}

/// As metadata.yaml calls it.
const char* identifier_of(SessionStorage storage) {
  return storage == SessionStorage::kMcap ? "mcap" : "sqlite3";
}

Result<SessionFile> session_file(const YAML::Node& bag, const std::string& name) {
  const auto wrong = [&](const char* key, std::string what) {
    return Problem{{name, 0, key}, std::move(what)};
  };
  const std::string storage = scalar(bag, "storage_identifier").value_or("");
  if (storage != "sqlite3" && storage != "mcap") {
    return wrong(
        "storage_identifier",
        fmt::format("'{}' is not read, only sqlite3 and mcap; `ros2 bag convert` makes one", storage));
  }
  if (const std::string format = scalar(bag, "compression_format").value_or(""); !format.empty()) {
    return wrong("compression_format",
                 fmt::format("'{}' is not read, only bags that are not compressed as a whole; "
                             "`ros2 bag convert` makes one",
                             format));
  }
  const YAML::Node files = bag["relative_file_paths"];
  if (!files || !files.IsSequence() || files.size() == 0 || !files[0].IsScalar())
    return wrong("relative_file_paths", "names no database");
  if (files.size() > 1) {
    return wrong(
        "relative_file_paths",
        fmt::format("names {} files; a bag of one is read, and `ros2 bag convert` makes one", files.size()));
  }
  const std::string file = files[0].Scalar();
  if (file.empty() || file == "." || file == ".." || file.find('/') != std::string::npos)
    return wrong("relative_file_paths", fmt::format("'{}' is not a file beside metadata.yaml", file));
  const YAML::Node duration = bag["duration"];
  return SessionFile{.storage = storage == "mcap" ? SessionStorage::kMcap : SessionStorage::kSqlite,
                     .name = file,
                     .messages = whole_number(bag["message_count"]),
                     .duration_s = duration && duration.IsMap()
                                       ? static_cast<double>(whole_number(duration["nanoseconds"])) / 1e9
                                       : 0};
}

}  // namespace

std::string quality_of_service(bool latched) {
  const char* forever = "    sec: 9223372036\n    nsec: 854775807\n";
  return fmt::format(
      "- history: {}\n  depth: {}\n  reliability: 1\n  durability: {}\n"
      "  deadline:\n{}  lifespan:\n{}  liveliness: 1\n  liveliness_lease_duration:\n{}"
      "  avoid_ros_namespace_conventions: false",
      latched ? 1 : 3, latched ? 1 : 0, latched ? 1 : 2, forever, forever, forever);
}

bool is_latched(const std::string& quality) {
  return quality.find("durability: 1\n") != std::string::npos ||
         quality.find("durability: transient_local") != std::string::npos;
}

std::string metadata_yaml(const SessionMetadata& metadata) {
  const std::string duration = fmt::format("nanoseconds: {}", metadata.last - metadata.first);
  const std::string start = fmt::format("nanoseconds_since_epoch: {}", metadata.first);
  std::string topics;
  for (const auto& topic : metadata.topics) topics += topic_yaml(topic);
  return fmt::format(
      "rosbag2_bagfile_information:\n"
      "  version: {}\n"
      "  storage_identifier: {}\n"
      "  duration:\n    {}\n"
      "  starting_time:\n    {}\n"
      "  message_count: {}\n"
      "  topics_with_message_count:{}\n{}"
      "  compression_format: \"\"\n"
      "  compression_mode: \"\"\n"
      "  relative_file_paths:\n    - {}\n"
      "  files:\n"
      "    - path: {}\n"
      "      starting_time:\n        {}\n"
      "      duration:\n        {}\n"
      "      message_count: {}\n",
      kMetadataVersion, identifier_of(metadata.storage), duration, start, metadata.messages,
      topics.empty() ? " []" : "", topics, json_quoted(metadata.file_name), json_quoted(metadata.file_name),
      start, duration, metadata.messages);
}

Result<SessionFile> parse_session_file(const std::string& text, const std::string& name) {
  try {
    const YAML::Node root = load_yaml(text);
    const YAML::Node bag = root.IsMap() ? root["rosbag2_bagfile_information"] : YAML::Node();
    if (!bag || !bag.IsMap())
      return Problem{{name, 0, "rosbag2_bagfile_information"}, "is missing: this is not a bag's metadata"};
    return session_file(bag, name);
  } catch (const YAML::Exception& error) {
    return Problem{{name, error.mark.line + 1}, "is not YAML: " + error.msg};
  }
}

}  // namespace aisle
