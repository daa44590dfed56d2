#include "aisle/formats/connections/connection_file.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "aisle/formats/whole_file.hpp"
#include "connections/connection_fields.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "object_reader.hpp"
#include "object_yaml.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kPeersMax = 32;
constexpr std::size_t kListedMax = 16;
constexpr std::string_view kHeader = "format: aisle.connection\nversion: 1\n";

/// Reads one document.
class ConnectionReader {
 public:
  explicit ConnectionReader(const std::string& file) : nodes_(file) { connection_.file = file; }

  Result<Connection> read(const YAML::Node& document) {
    if (document.IsMap()) {
      nodes_.read_map(document, "", fields_of(connection_), sections());
    } else {
      nodes_.problem(document, "",
                     "is not a connection: expected keys, the first 'format: aisle.connection'");
    }
    if (nodes_.problem_count() > 0) return nodes_.take_problems();
    return std::move(connection_);
  }

 private:
  using Section = ObjectReader::Section;

  std::vector<Section> sections() {
    std::vector<Section> sections = {
        nodes_.constant("format", "aisle.connection"),
        nodes_.constant("version", "1"),
        {"network", [this](const YAML::Node& node, const std::string& key) { read_network(node, key); }}};
    for_each_object(connection_, [&](std::string_view name, auto& object) {
      sections.push_back({name, [this, &object](const YAML::Node& node, const std::string& key) {
                            nodes_.read_map(node, key, fields_of(object));
                          }});
    });
    for_each_list(connection_, [&](std::string_view name, auto& listed) {
      sections.push_back({name, [this, &listed](const YAML::Node& node, const std::string& key) {
                            read_list(node, key, listed);
                          }});
    });
    return sections;
  }

  void read_network(const YAML::Node& node, const std::string& key) {
    ConnectedNetwork& network = connection_.network;
    nodes_.read_map(
        node, key, fields_of(network),
        {{"peers", [this](const YAML::Node& peers, const std::string& inner) { read_peers(peers, inner); }}});
  }

  void read_peers(const YAML::Node& node, const std::string& key) {
    if (!nodes_.is_list(node, key) || !nodes_.is_room_left(node, key, node.size(), kPeersMax)) return;
    std::vector<std::string> peers;
    for (const YAML::Node& peer : node) {
      if (!peer.IsScalar() || peer.Scalar().empty() || !is_line_of_text(peer.Scalar()))
        return nodes_.problem(peer, key, "is not a list of addresses");
      peers.push_back(peer.Scalar());
    }
    connection_.network.peers = std::move(peers);
  }

  template <class Object>
  void read_list(const YAML::Node& node, const std::string& key, std::vector<Object>& listed) {
    if (!nodes_.is_list(node, key) || !nodes_.is_room_left(node, key, node.size(), kListedMax)) return;
    for (std::size_t i = 0; i < node.size(); ++i) {
      Object read;
      const std::string place = fmt::format("{}[{}]", key, i);
      nodes_.read_map(node[i], place, fields_of(read));
      check(node[i], place, read);
      listed.push_back(std::move(read));
    }
  }

  void check(const YAML::Node& /*node*/, const std::string& /*key*/, const ConnectedSwitch& /*read*/) {}

  /// A camera's name is part of a topic's name, and each has its own.
  void check(const YAML::Node& node, const std::string& key, ConnectedCamera& camera) {
    if (!is_topic_word(camera.name))
      nodes_.problem(node, key + ".name", "is not a camera name: a letter, then letters, digits and _");
    for (const ConnectedCamera& other : connection_.cameras) {
      if (other.name == camera.name)
        nodes_.problem(node, key + ".name", fmt::format("'{}' is the name of two cameras", camera.name));
    }
    std::size_t given = camera.topic.empty() ? 0 : 1;
    for (const CameraSource::Origin& origin : camera.source.origins()) given += origin.text->empty() ? 0 : 1;
    if (given != 1) {
      nodes_.problem(node, key,
                     fmt::format("{} of topic, device, url and folder are given, instead of one", given));
    } else if (camera.topic.empty()) {
      for (const Problem& problem : camera.source.problems())
        nodes_.problem(node, key + "." + problem.where.key, problem.what);
    }
  }

  Connection connection_;
  ObjectReader nodes_;
};

template <class Object>
std::string block_text(std::string_view key, Object object) {
  std::string text = fmt::format("{}:\n", key);
  for (const ObjectField& field : fields_of(object))
    text += fmt::format("  {}: {}\n", field.key, yaml_value(field, "  "));
  return text;
}

std::string network_text(const ConnectedNetwork& network) {
  std::vector<std::string> peers;
  for (const std::string& peer : network.peers) peers.push_back(yaml_quoted(peer));
  return block_text("network", network) + fmt::format("  peers: [{}]\n", fmt::join(peers, ", "));
}

/// A limit of the connection, taken where it is given.
class LimitCheck {
 public:
  explicit LimitCheck(const std::string& file) : file_(file) {}

  void lower(const char* key, double allowed, double& limit, double unit = 1) {
    if (allowed == 0) return;
    if (allowed > limit * (1 + 1e-9)) {
      problems_.push_back({{file_, 0, fmt::format("limits.{}", key)},
                           fmt::format("{:g} is above the vehicle's own limit of {:g}: a connection may only "
                                       "lower it",
                                       allowed / unit, limit / unit)});
    }
    limit = allowed;
  }

  Problems take_problems() { return std::move(problems_); }

 private:
  std::string file_;
  Problems problems_;
};

}  // namespace

std::string Connection::topic(const std::string& name) const {
  if (name.starts_with('/')) return name;
  std::string space = network.name_space;
  if (!space.empty() && !space.starts_with('/')) space.insert(0, "/");
  while (space.ends_with('/')) space.pop_back();
  return space + "/" + name;
}

bool ConnectedCamera::has_compressed_images() const {
  return messages == Messages::kCompressed || (messages == Messages::kAuto && topic.ends_with("/compressed"));
}

/// As image_transport has it: /front/camera_info of /front/image_raw and /front/image_raw/compressed.
std::string ConnectedCamera::calibration_topic() const {
  if (!calibration.empty()) return calibration;
  constexpr std::string_view kCompressed = "/compressed";
  std::string images = topic;
  if (images.ends_with(kCompressed)) images.resize(images.size() - kCompressed.size());
  return images.substr(0, images.rfind('/') + 1) + "camera_info";
}

Result<Connection> read_connection(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kSettingsBytesMax);
  if (!text) return text.problems();
  return parse_connection(*text, path.string());
}

Result<Connection> parse_connection(const std::string& text, const std::string& name) {
  try {
    return ConnectionReader(name).read(load_yaml(text));
  } catch (const YAML::Exception& error) {
    return Problem{{name, error.mark.line + 1}, "is not YAML: " + error.msg};
  }
}

std::string connection_yaml(const Connection& connection) {
  std::string text{kHeader};
  Connection copy = connection;
  for (const ObjectField& field : fields_of(copy))
    text += fmt::format("{}: {}\n", field.key, yaml_value(field, "  "));
  text += network_text(connection.network);
  for_each_object(connection,
                  [&](std::string_view key, const auto& object) { text += block_text(key, object); });
  for_each_list(connection,
                [&](std::string_view key, const auto& listed) { text += yaml_list(key, listed); });
  return text;
}

Result<DriveLimits> limits_over(const Connection& connection, const DriveLimits& of_vehicle) {
  DriveLimits limits = of_vehicle;
  const ConnectedLimits& allowed = connection.limits;
  LimitCheck check(connection.file);
  check.lower("speed_max_mps", allowed.speed_max_mps, limits.speed_max_mps);
  check.lower("reverse_speed_max_mps", allowed.reverse_speed_max_mps, limits.reverse_speed_max_mps);
  check.lower("turn_rate_max_deg_s", allowed.turn_rate_max_rad_s, limits.turn_rate_max_rad_s, kDegree);
  if (Problems problems = check.take_problems(); !problems.empty()) return problems;
  return limits;
}

}  // namespace aisle
