#include "aisle/formats/logs/read_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "aisle/formats/whole_file.hpp"
#include "bags/bag_streams.hpp"
#include "field_reader.hpp"
#include "logs/laser_csv_columns.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

bool has_poses(const BagTopic& topic) {
  const TopicUse use = use_of(topic);
  return topic.messages > 0 && (use == TopicUse::kOdometry || use == TopicUse::kPose);
}

Result<std::size_t> choose_poses(const std::vector<BagTopic>& topics, const std::string& wanted,
                                 const std::string& file) {
  std::vector<BagTopic> found;
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (!has_poses(topics[i]) || (!wanted.empty() && topics[i].name != wanted)) continue;
    found.push_back(topics[i]);
    chosen = i;
  }
  if (found.size() == 1) return chosen;
  if (found.empty())
    return Problem{{file, 0, wanted}, "has no such poses or odometry; " + topic_list(topics)};
  return Problem{{file}, "has several topics of poses: name one of them; " + topic_list(found)};
}

Result<Trajectory> read_bag_poses(const std::filesystem::path& path, const std::string& wanted) {
  auto bag = BagReader::open(path);
  if (!bag) return bag.problems();
  const auto topic = choose_poses(bag->topics(), wanted, path.string());
  if (!topic) return topic.problems();
  TopicChoice choice;
  choice.pose = *topic;
  Problems left_out;
  const auto streams = read_streams(*bag, choice, path.string(), left_out);
  if (!streams) return streams.problems();
  Trajectory trajectory;
  for (const BagPose& pose : streams->pose.poses) {
    const bool is_stamped = pose.time.stamp > 0;
    trajectory.stamps_s.push_back(ros::stamp_s(is_stamped ? pose.time.stamp : pose.time.log_stamp));
    trajectory.T_map_vehicle.push_back(pose.T_parent_child);
  }
  return trajectory;
}

Trajectory in_order(const Trajectory& trajectory) {
  const auto& stamps_s = trajectory.stamps_s;
  std::vector<std::size_t> order(stamps_s.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return stamps_s[a] < stamps_s[b]; });
  Trajectory sorted;
  for (const std::size_t i : order) {
    if (!sorted.stamps_s.empty() && stamps_s[i] == sorted.stamps_s.back()) continue;
    sorted.stamps_s.push_back(stamps_s[i]);
    sorted.T_map_vehicle.push_back(trajectory.T_map_vehicle[i]);
  }
  return sorted;
}

/// A table's first line that is no comment names columns, which no line of TUM does.
bool is_pose_table(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = trimmed(take_line(text));
    if (!line.empty() && line.front() != '#') return line.find("time") != std::string_view::npos;
  }
  return false;
}

class PoseRows {
 public:
  explicit PoseRows(const std::string& name) : problems_(name) {}

  void read(std::string_view line, long line_number, const CsvColumns& columns) {
    split_csv_line(line, columns.separator, cells_);
    if (cells_.size() != columns.names.size()) {
      problems_.add(line_number,
                    fmt::format("has {} columns, the header has {}", cells_.size(), columns.names.size()));
      return;
    }
    const auto number = [&](const CsvColumn& column, double limit) {
      const auto value = parse_number(cells_[column.index]);
      if (value && std::abs(*value * column.scale) <= limit) return *value * column.scale;
      problems_.add(line_number, columns.names[column.index],
                    fmt::format("'{}' is no number that makes sense", printable(cells_[column.index])));
      return 0.0;
    };
    constexpr double kStampMax_s = 1e11, kPoseMax_m = 1e7, kHeadingMax_rad = 1e6;
    trajectory_.stamps_s.push_back(number(columns.time, kStampMax_s));
    trajectory_.T_map_vehicle.push_back({number(*columns.x, kPoseMax_m), number(*columns.y, kPoseMax_m),
                                         number(*columns.heading, kHeadingMax_rad)});
  }

  Result<Trajectory> take() {
    if (!problems_.empty()) return problems_.take();
    return std::move(trajectory_);
  }

 private:
  ProblemList problems_;
  Trajectory trajectory_;
  std::vector<std::string_view> cells_;
};

}  // namespace

Result<Trajectory> parse_pose_csv(std::string_view text, const std::string& name) {
  std::optional<CsvColumns> columns;
  PoseRows rows(name);
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  for (long line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    const std::string_view content = trimmed(line);
    if (content.empty() || content.front() == '#') continue;
    if (columns) {
      rows.read(line, line_number, *columns);
      continue;
    }
    auto header = read_csv_header(line, name, line_number, CsvRows::kPoses);
    if (!header) return header.problems();
    columns = std::move(*header);
  }
  if (!columns) return Problem{{name}, "has no header line that names the columns"};
  return rows.take();
}

Result<Trajectory> read_poses(const std::filesystem::path& path, const std::string& topic) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return Problem{{path.string()}, "no such file"};
  const bool is_in_bag = is_bag(path);
  if (!is_in_bag && !topic.empty())
    return Problem{{path.string()}, "has no topics: " + topic + " is for bags"};
  const auto read_text = [&]() -> Result<Trajectory> {
    const Result<std::string> text = read_whole_file(path);
    if (!text) return text.problems();
    return is_pose_table(*text) ? parse_pose_csv(*text, path.string()) : parse_tum(*text, path.string());
  };
  const auto trajectory = is_in_bag ? read_bag_poses(path, topic) : read_text();
  if (!trajectory) return trajectory.problems();
  if (trajectory->stamps_s.empty()) return Problem{{path.string()}, "has no pose"};
  return in_order(*trajectory);
}

}  // namespace aisle
