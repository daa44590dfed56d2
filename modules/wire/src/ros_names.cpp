#include "ros_names.hpp"

namespace aisle {
namespace {

constexpr const char* kTopicPrefix = "rt/";
constexpr const char* kTypeNamespace = "dds_::";

std::string with(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace

std::string dds_topic(const std::string& ros_topic) {
  return kTopicPrefix + (ros_topic.starts_with('/') ? ros_topic.substr(1) : ros_topic);
}

std::optional<std::string> ros_topic(const std::string& dds_topic) {
  if (!dds_topic.starts_with(kTopicPrefix)) return std::nullopt;
  return "/" + dds_topic.substr(3);
}

std::string dds_type(const std::string& ros_type) {
  const std::size_t name = ros_type.rfind('/') + 1;
  return with(ros_type.substr(0, name), "/", "::") + kTypeNamespace + ros_type.substr(name) + "_";
}

std::string ros_type(const std::string& dds_type) {
  const std::size_t name = dds_type.find(kTypeNamespace);
  if (name == std::string::npos || !dds_type.ends_with('_')) return dds_type;
  const std::string bare = dds_type.substr(name + 6, dds_type.size() - name - 7);
  return with(dds_type.substr(0, name), "::", "/") + bare;
}

}  // namespace aisle
