#include "bags/motion_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace aisle {
namespace {

constexpr double kMissing_s = 2;  ///< a longer gap, and /tf is looked at

double longest_gap_s(const BagMotion& motion) {
  ros::Stamp_ns longest = 0;
  for (std::size_t i = 1; i < motion.poses.size(); ++i)
    longest = std::max(longest, motion.poses[i].time.stamp - motion.poses[i - 1].time.stamp);
  return static_cast<double>(longest) * 1e-9;
}

/// The vehicle's odometry among the transforms; nullptr if there is none.
BagMotion* best_transforms(BagStreams& streams) {
  const auto score = [](const BagMotion& motion) {
    const std::string name = motion.child.substr(motion.child.rfind('/') + 1);
    const double by_name = name == "base_link" ? 2.1 : name.find("base") != std::string::npos ? 2 : 1;
    return by_name * static_cast<double>(motion.poses.size());
  };
  BagMotion* best = nullptr;
  for (auto& [frames, motion] : streams.by_transforms) {
    if (motion.poses.size() < 2) continue;
    if (best == nullptr || score(motion) > score(*best)) best = &motion;
  }
  return best;
}

}  // namespace

BagMotion choose_motion(BagStreams& streams, const TopicChoice& choice, const std::string& wanted,
                        const std::string& file, Problems& warnings) {
  const auto warn = [&](const std::string& key, std::string what) {
    warnings.push_back({{file, 0, key}, std::move(what)});
  };
  if (wanted == "none") return {};
  BagMotion* const transforms = best_transforms(streams);
  if (choice.odometry && !streams.odometry.poses.empty()) {
    const double gap_s = longest_gap_s(streams.odometry);
    const bool tf_knows_more = wanted.empty() && transforms != nullptr && gap_s > kMissing_s &&
                               longest_gap_s(*transforms) < gap_s / 2;
    if (!tf_knows_more) return std::move(streams.odometry);
    warn(transforms->source,
         fmt::format("gives the odometry ({} -> {}), for {} has nothing for {:.1f} s", transforms->parent,
                     transforms->child, streams.odometry.source, gap_s));
    return std::move(*transforms);
  }
  if (transforms != nullptr) {
    if (!choice.by_transforms_only)
      warn(transforms->source, fmt::format("gives the odometry ({} -> {}), for no topic has it",
                                           transforms->parent, transforms->child));
    return std::move(*transforms);
  }
  if (!streams.pose.poses.empty() && !choice.by_transforms_only) {
    warn(streams.pose.source,
         "is taken for the odometry, for there is none: it is a pose that something else measured");
    return std::move(streams.pose);
  }
  return {};
}

}  // namespace aisle
