#include "bags/topic_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "aisle/formats/bags/bag_scan.hpp"

namespace aisle {
namespace {

constexpr long kTried = 30;  ///< scans of a topic that tell whether it sees anything

bool is_one_of(const std::string& type, std::initializer_list<const char*> types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

/// The part after the last slash, in small letters.
std::string leaf(const std::string& name) {
  std::string last = name.substr(name.rfind('/') + 1);
  std::transform(last.begin(), last.end(), last.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return last;
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

bool is_named(const BagTopic& topic, std::string_view name) {
  const std::string_view own = topic.name;
  return own == name || own == "/" + std::string(name) || "/" + std::string(own) == name;
}

std::vector<std::size_t> topics_for(const std::vector<BagTopic>& topics, TopicUse use) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (use_of(topics[i]) == use && (topics[i].messages > 0 || use == TopicUse::kTransforms))
      found.push_back(i);
  }
  return found;
}

std::string names_of(const std::vector<BagTopic>& topics, const std::vector<std::size_t>& which) {
  std::string names;
  for (const std::size_t i : which)
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", topics[i].name, topics[i].messages);
  return names;
}

/// The share of the readings that are distances, in the first scans of each topic.
Result<std::map<std::size_t, double>> shares_seen(BagReader& bag, const std::vector<std::size_t>& scans) {
  struct Seen {
    long scans = 0, readings = 0, distances = 0;
  };
  std::map<std::size_t, Seen> seen;
  bag.want(scans);
  std::size_t tried = 0;
  while (tried < scans.size()) {
    const auto message = bag.next();
    if (!message) return message.problems();
    if (!*message) break;
    const BagTopic& topic = bag.topics()[(*message)->topic];
    Seen& here = seen[(*message)->topic];
    if (++here.scans == std::min<long>(kTried, topic.messages)) ++tried;
    if (here.scans > kTried) continue;
    const auto scan = parse_message<ros::LaserScan>((*message)->bytes, topic.encoding);
    ScanDoubts doubts;
    const auto taken = scan ? bag_scan(*scan, {}, doubts) : std::nullopt;
    if (!taken) continue;
    here.readings += static_cast<long>(taken->ranges_m.size());
    here.distances += std::count_if(taken->ranges_m.begin(), taken->ranges_m.end(),
                                    [](float range_m) { return range_m > 0 && std::isfinite(range_m); });
  }
  std::map<std::size_t, double> shares;
  for (const auto& [topic, here] : seen)
    shares[topic] = static_cast<double>(here.distances) / static_cast<double>(std::max(1L, here.readings));
  return shares;
}

Result<std::size_t> best_scans(BagReader& bag, const std::vector<std::size_t>& scans, const std::string& file,
                               Problems& warnings) {
  if (scans.size() == 1) return scans.front();
  auto shares = shares_seen(bag, scans);
  if (!shares) return shares.problems();
  const auto score = [&](std::size_t i) {
    const std::string name = leaf(bag.topics()[i].name);
    const double by_name = name == "scan" ? 1.5 : contains(name, "scan") ? 1.2 : 1;
    return static_cast<double>(bag.topics()[i].messages) * by_name * ((*shares)[i] > 0.02 ? 1 : 1e-6);
  };
  const std::size_t best =
      *std::max_element(scans.begin(), scans.end(), [&](auto a, auto b) { return score(a) < score(b); });
  warnings.push_back(
      {{file, 0, bag.topics()[best].name},
       fmt::format("is taken of the topics with scans: {}; --scan A,B takes two scanners of one vehicle",
                   names_of(bag.topics(), scans))});
  return best;
}

Problem no_such_topic(const std::string& file, const std::string& name, const std::vector<BagTopic>& topics) {
  return {{file, 0, name}, "is no such topic of the bag; " + topic_list(topics)};
}

/// The topic with this name and use. @param called  what it must have: "scans"
Result<std::size_t> named_topic(const std::vector<BagTopic>& topics, const std::string& name, TopicUse use,
                                const char* called, const std::string& file) {
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (is_named(topics[i], name) && use_of(topics[i]) == use) return i;
  }
  for (const BagTopic& topic : topics) {
    if (is_named(topic, name))
      return Problem{{file, 0, name}, fmt::format("has no {} but {}", called, topic.type)};
  }
  return no_such_topic(file, name, topics);
}

Result<std::vector<std::size_t>> named_scans(const std::vector<BagTopic>& topics, const std::string& names,
                                             const std::string& file) {
  std::vector<std::size_t> chosen;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t comma = std::min(names.find(',', begin), names.size());
    std::string name = names.substr(begin, comma - begin);
    std::erase(name, ' ');
    begin = comma + 1;
    const auto found = named_topic(topics, name, TopicUse::kScan, "scans", file);
    if (!found) return found.problems();
    chosen.push_back(*found);
  }
  return chosen;
}

/// The best topic of a use by name and number of messages; nullopt if none will do.
std::optional<std::size_t> best_motion(const std::vector<BagTopic>& topics, TopicUse use,
                                       const std::string& file, Problems& warnings) {
  std::vector<std::size_t> candidates = topics_for(topics, use);
  std::erase_if(candidates, [&](std::size_t i) {
    const std::string name = leaf(topics[i].name);
    return is_truth(topics[i]) || topics[i].messages < 2 || contains(name, "goal") ||
           contains(name, "initialpose") || contains(name, "target");
  });
  if (candidates.empty()) return std::nullopt;
  const auto score = [&](std::size_t i) {
    const std::string name = leaf(topics[i].name);
    const double by_name = name == "odom" ? 3 : contains(name, "odom") || contains(name, "pose") ? 1.5 : 1;
    return by_name * static_cast<double>(topics[i].messages);
  };
  const std::size_t best = *std::max_element(candidates.begin(), candidates.end(),
                                             [&](auto a, auto b) { return score(a) < score(b); });
  if (candidates.size() > 1)
    warnings.push_back(
        {{file, 0, topics[best].name},
         fmt::format("is taken of the topics with odometry or poses: {}", names_of(topics, candidates))});
  return best;
}

Problems choose_motion(const std::vector<BagTopic>& topics, const std::string& wanted,
                       const std::string& file, TopicChoice& choice, Problems& warnings) {
  choice.transforms = topics_for(topics, TopicUse::kTransforms);
  choice.by_transforms_only = wanted == "tf";
  if (wanted == "none" || wanted == "tf") return {};
  if (wanted.empty()) {
    choice.odometry = best_motion(topics, TopicUse::kOdometry, file, warnings);
    if (!choice.odometry) choice.pose = best_motion(topics, TopicUse::kPose, file, warnings);
    return {};
  }
  for (std::size_t i = 0; i < topics.size(); ++i) {
    const TopicUse use = use_of(topics[i]);
    if (!is_named(topics[i], wanted)) continue;
    if (use != TopicUse::kOdometry && use != TopicUse::kPose)
      return {{{file, 0, wanted}, "has neither odometry nor poses but " + topics[i].type}};
    choice.odometry = i;
    return {};
  }
  return {no_such_topic(file, wanted, topics)};
}

/// Those that the user names, or the best one; none if the bag has no scans.
Result<std::vector<std::size_t>> choose_scans(BagReader& bag, const RecordingOptions& options,
                                              const std::string& file, Problems& warnings) {
  if (!options.scan_topic.empty()) return named_scans(bag.topics(), options.scan_topic, file);
  const std::vector<std::size_t> scans = topics_for(bag.topics(), TopicUse::kScan);
  if (scans.empty()) return scans;
  const auto best = best_scans(bag, scans, file, warnings);
  if (!best) return best.problems();
  return std::vector<std::size_t>{*best};
}

Result<std::size_t> only_images(const std::vector<BagTopic>& topics, const std::string& file) {
  const std::vector<std::size_t> found = topics_for(topics, TopicUse::kImages);
  if (found.size() == 1) return found.front();
  if (found.empty()) {
    return Problem{
        {file},
        "has no images (sensor_msgs/msg/Image, sensor_msgs/msg/CompressedImage); " + topic_list(topics)};
  }
  return Problem{{file},
                 fmt::format("has images on {} topics, {}: --camera TOPIC names the one to be read",
                             found.size(), names_of(topics, found))};
}

/// A camera's calibration is beside its images: /front/camera_info of /front/image_raw/compressed.
/// @return the one that begins as most of the images' name; nullopt if there is none
std::optional<std::size_t> calibration_of(const std::vector<BagTopic>& topics, const std::string& images) {
  std::optional<std::size_t> best;
  std::size_t best_length = 0;
  for (const std::size_t i : topics_for(topics, TopicUse::kCalibration)) {
    const std::string beside = topics[i].name.substr(0, topics[i].name.rfind('/') + 1);
    if (!images.starts_with(beside) || (best && beside.size() <= best_length)) continue;
    best = i;
    best_length = beside.size();
  }
  return best;
}

}  // namespace

TopicUse use_of(const BagTopic& topic) {
  if (topic.type == "sensor_msgs/msg/LaserScan") return TopicUse::kScan;
  if (topic.type == "nav_msgs/msg/Odometry") return TopicUse::kOdometry;
  if (is_one_of(topic.type, {"tf2_msgs/msg/TFMessage", "tf/msg/tfMessage"})) return TopicUse::kTransforms;
  if (is_one_of(topic.type, {"geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/PoseWithCovarianceStamped",
                             "geometry_msgs/msg/TransformStamped", "geometry_msgs/msg/Pose"}))
    return TopicUse::kPose;
  if (is_one_of(topic.type, {"sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage"}))
    return TopicUse::kImages;
  if (topic.type == "sensor_msgs/msg/CameraInfo") return TopicUse::kCalibration;
  return TopicUse::kNone;
}

bool is_truth(const BagTopic& topic) {
  return contains(topic.name, "truth");
}

std::string topic_list(const std::vector<BagTopic>& topics) {
  constexpr std::size_t kListed = 30;
  std::string list;
  for (std::size_t i = 0; i < std::min(topics.size(), kListed); ++i)
    list +=
        fmt::format("{}{} ({}, {})", i == 0 ? "" : ", ", topics[i].name, topics[i].type, topics[i].messages);
  if (topics.size() > kListed) list += fmt::format(" and {} more", topics.size() - kListed);
  return "it has " + (topics.empty() ? "no topics" : list);
}

Result<TopicChoice> choose_topics(BagReader& bag, const RecordingOptions& options, const std::string& file,
                                  Problems& warnings) {
  auto scans = choose_scans(bag, options, file, warnings);
  if (!scans) return scans.problems();
  if (scans->empty())
    return Problem{{file}, "has no scans (sensor_msgs/msg/LaserScan); " + topic_list(bag.topics())};
  TopicChoice choice{.scans = std::move(*scans)};
  if (Problems problems = choose_motion(bag.topics(), options.odometry, file, choice, warnings);
      !problems.empty())
    return problems;
  return choice;
}

Result<TopicChoice> choose_image_topics(BagReader& bag, const std::string& images,
                                        const RecordingOptions& options, const std::string& file,
                                        Problems& warnings) {
  const std::vector<BagTopic>& topics = bag.topics();
  const auto chosen = images.empty() ? only_images(topics, file)
                                     : named_topic(topics, images, TopicUse::kImages, "images", file);
  if (!chosen) return chosen.problems();
  auto scans = choose_scans(bag, options, file, warnings);
  if (!scans) return scans.problems();
  TopicChoice choice{.scans = std::move(*scans), .images = *chosen};
  choice.calibration = calibration_of(topics, topics[*chosen].name);
  if (Problems problems = choose_motion(topics, options.odometry, file, choice, warnings); !problems.empty())
    return problems;
  return choice;
}

}  // namespace aisle
