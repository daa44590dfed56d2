#include "detection/line_pursuit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace aisle {

void LinePursuit::add(const Image& image, const std::vector<VerticalLine>& lines,
                      nlohmann::ordered_json& figures) {
  const std::vector<int> numbers = follower_.follow(to_grey(image), lines);
  sheet_.add(image, lines, numbers);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ++images_of_[numbers[i]];
    figures[i]["number"] = numbers[i];
  }
}

int LinePursuit::followed() const {
  return static_cast<int>(std::count_if(images_of_.begin(), images_of_.end(),
                                        [](const auto& entry) { return entry.second > 1; }));
}

int LinePursuit::longest() const {
  int longest = 0;
  for (const auto& [number, images] : images_of_) longest = std::max(longest, images);
  return longest;
}

nlohmann::ordered_json LinePursuit::figures() const {
  return {{"lines", images_of_.size()}, {"followed", followed()}, {"longest_pictures", longest()}};
}

std::string LinePursuit::summary() const {
  return fmt::format("{} different lines, {} of them followed, the longest through {} images\n",
                     images_of_.size(), followed(), longest());
}

}  // namespace aisle
