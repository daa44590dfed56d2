#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/report/followed_lines_sheet.hpp"
#include "aisle/vision/lines/line_follower.hpp"

namespace aisle {

/// Vertical lines followed through the images of one drive.
class LinePursuit {
 public:
  /// @param images  how many there will be, at least 1
  LinePursuit(const LineFollowerParams& params, std::size_t images) : follower_(params), sheet_(images) {}

  /// The next image. @param figures  list with an object for each line, to which the line's `number` is added
  void add(const Image& image, const std::vector<VerticalLine>& lines, nlohmann::ordered_json& figures);

  /// How many lines were followed, and through how many images.
  nlohmann::ordered_json figures() const;
  /// The same for people.
  std::string summary() const;
  std::string sheet_png() const { return sheet_.png(); }

 private:
  int followed() const;
  int longest() const;

  LineFollower follower_;
  FollowedLinesSheet sheet_;
  std::map<int, int> images_of_;  // number of a line -> images that show it
};

}  // namespace aisle
