#include "ros_names.hpp"

#include <algorithm>

namespace aisle {
namespace {

constexpr std::string_view kTopicPrefix = "rt";
constexpr std::string_view kMessages = "/msg/";
constexpr std::string_view kDdsMessages = "::msg::dds_::";
/// Names longer than this do not go through every DDS (Fast DDS: 255 with the prefix).
constexpr std::size_t kNameMax = 250;

bool is_word(std::string_view text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_plain);
}

}  // namespace

bool is_ros_topic(std::string_view topic) {
  if (topic.size() > kNameMax || !topic.starts_with('/')) return false;
  while (!topic.empty()) {
    topic.remove_prefix(1);
    const std::string_view word = topic.substr(0, topic.find('/'));
    if (!is_word(word)) return false;
    topic.remove_prefix(word.size());
  }
  return true;
}

bool is_ros_type(std::string_view type) {
  const std::size_t messages = type.find(kMessages);
  return type.size() <= kNameMax && messages != std::string_view::npos && is_word(type.substr(0, messages)) &&
         is_word(type.substr(messages + kMessages.size()));
}

std::string dds_topic(std::string_view topic) {
  return std::string(kTopicPrefix).append(topic);
}

std::string dds_type(std::string_view type) {
  const std::size_t messages = type.find(kMessages);
  return std::string(type.substr(0, messages))
      .append(kDdsMessages)
      .append(type.substr(messages + kMessages.size()))
      .append("_");
}

std::optional<std::string> ros_topic(std::string_view dds) {
  if (!dds.starts_with(kTopicPrefix) || !is_ros_topic(dds.substr(kTopicPrefix.size()))) return std::nullopt;
  return std::string(dds.substr(kTopicPrefix.size()));
}

std::string ros_type(std::string_view dds) {
  const std::size_t messages = dds.find(kDdsMessages);
  if (messages == std::string_view::npos || !dds.ends_with('_')) return std::string(dds);
  const std::string_view name = dds.substr(messages + kDdsMessages.size());
  return std::string(dds.substr(0, messages)).append(kMessages).append(name.substr(0, name.size() - 1));
}

}  // namespace aisle
