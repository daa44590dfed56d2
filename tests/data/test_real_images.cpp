/// Detectors on real images, which are not part of the repository. Each test prints its figures.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <regex>

#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/vision/check/view_check.hpp"
#include "aisle/vision/places/brightness_view.hpp"
#include "aisle/vision/places/place_recogniser.hpp"
#include "aisle/vision/route/route_region.hpp"
#include "aisle/vision/stripes/laser_stripes.hpp"
#include "real_data.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

fs::path images(const std::string& set) {
  return real_data() / "images" / set;
}

Image read(const fs::path& path) {
  const auto image = read_image(path);
  if (!image) throw std::runtime_error(to_string(image.problems()));
  return *image;
}

std::vector<fs::path> jpegs_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".jpg") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Intersection over union of two masks of one size.
double overlap(const Image& a, const Image& b) {
  std::size_t both = 0, either = 0;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) {
    both += static_cast<std::size_t>(a.bytes[i] > 127 && b.bytes[i] > 127);
    either += static_cast<std::size_t>(a.bytes[i] > 127 || b.bytes[i] > 127);
  }
  return static_cast<double>(both) / static_cast<double>(either);
}

/// Mean overlap of the region with the hand-labelled visible floor, over a folder.
double mean_overlap(const fs::path& folder, const RegionParams& params = {}) {
  double sum = 0;
  const auto files = jpegs_in(folder);
  for (const fs::path& file : files) {
    const fs::path label = folder / (file.stem().string() + "_floorvisible.png");
    sum += overlap(find_route_region(read(file), params).mask, to_grey(read(label)));
  }
  return sum / static_cast<double>(files.size());
}

TEST(RealImages, TheRegionIsTheFloorOfCorridorsAndRooms) {
  const fs::path folder = images("hedau_layout");
  AISLE_NEEDS(folder);
  const double corridors = mean_overlap(folder / "corridor"), rooms = mean_overlap(folder / "room");
  fmt::print("floor region, mean intersection over union: corridors {:.3f}, rooms {:.3f}\n", corridors,
             rooms);
  EXPECT_GE(corridors, 0.80);
  EXPECT_GE(rooms, 0.70);
}

TEST(RealImages, ACoveredPlaceIsNoRoute) {
  const fs::path folder = images("mit_rss_cones");
  AISLE_NEEDS(folder);
  std::ifstream boxes(folder / "test_images_cone.csv");
  const std::regex line_of_box(R"re(.*/(test\d+\.jpg),"\(\((\d+), ?(\d+)\), \((\d+), ?(\d+)\)\)")re");
  std::smatch box;
  int cones = 0;
  double worst = 0;
  for (std::string line; std::getline(boxes, line);) {
    if (!std::regex_search(line, box, line_of_box) || !fs::exists(folder / box[1].str())) continue;
    const int left = std::stoi(box[2]), top = std::stoi(box[3]), right = std::stoi(box[4]);
    const int bottom = std::stoi(box[5]);
    const Image mask = find_route_region(read(folder / box[1].str())).mask;
    // A cone fills the middle third of its box from a quarter of the height down to the floor.
    int covered = 0, all = 0;
    for (int v = top + (bottom - top) / 4; v < std::min(bottom - 4, mask.height_px); ++v) {
      for (int u = left + (right - left) / 3; u < std::min(right - (right - left) / 3, mask.width_px); ++u) {
        covered += static_cast<int>(mask.row(v)[u] != 0);
        ++all;
      }
    }
    worst = std::max(worst, static_cast<double>(covered) / all);
    ++cones;
  }
  fmt::print("cones: {} images, at most {:.1f} % of a cone taken for route\n", cones, 100 * worst);
  EXPECT_EQ(cones, 10);
  EXPECT_LE(worst, 0.1);
}

/// The middle of a mask's row; nullopt if the row is empty.
std::optional<double> middle_of(const Image& mask, int row) {
  const std::uint8_t* begin = mask.row(row);
  const std::uint8_t* end = begin + mask.width_px;
  const auto is_drawn = [](std::uint8_t value) { return value > 127; };
  const auto first = std::find_if(begin, end, is_drawn);
  if (first == end) return std::nullopt;
  const auto last = std::find_if(std::reverse_iterator(end), std::reverse_iterator(begin), is_drawn).base();
  return (static_cast<double>(first - begin) + static_cast<double>(last - begin) - 1) / 2;
}

TEST(RealImages, TheMiddleOfTheRouteIsNearTheDrawnPath) {
  const fs::path folder = images("office_corridor_walkable");
  AISLE_NEEDS(folder);
  std::vector<double> off_shares;
  std::size_t rows = 0;
  for (const fs::path& file : jpegs_in(folder)) {
    const Image image = read(file), drawn = to_grey(read(fs::path(file).replace_extension(".png")));
    const Image region = find_route_region(image).mask;
    for (const double height_share : {0.7, 0.9}) {
      const int row = static_cast<int>(height_share * image.height_px);
      const auto due_px = middle_of(drawn, row);
      if (!due_px) continue;
      ++rows;
      const auto middle = find_route_middle(region, row, row);
      if (middle) off_shares.push_back(std::abs(middle->mean_px.x() - *due_px) / image.width_px);
    }
  }
  ASSERT_FALSE(off_shares.empty());
  std::sort(off_shares.begin(), off_shares.end());
  const double median = off_shares[off_shares.size() / 2], high = off_shares[off_shares.size() * 9 / 10];
  fmt::print("middle of the route: {} of {} rows, off by {:.3f} of the width (median), {:.3f} (9 in 10)\n",
             off_shares.size(), rows, median, high);
  EXPECT_GE(off_shares.size(), rows * 9 / 10);
  EXPECT_LE(median, 0.1);
}

/// The rows of all stripes in a range of columns that lie within 20 px of `row`.
std::vector<double> rows_near(const std::vector<LaserStripe>& stripes, double row, double first,
                              double last) {
  std::vector<double> rows;
  for (const LaserStripe& stripe : stripes)
    for (const Vec2& p : stripe.points_px)
      if (p.x() >= first && p.x() <= last && std::abs(p.y() - row) < 20) rows.push_back(p.y());
  return rows;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(RealImages, AStripesRowTellsTheDistance) {
  const fs::path folder = images("laser_line_uefs");
  AISLE_NEEDS(folder);
  struct Box {
    int distance_cm;
    double first, last;  ///< columns of the box, a little inside its edges
  };
  double squares = 0;
  int count = 0;
  const auto compare = [&](const std::vector<double>& rows, double expected) {
    ASSERT_GE(rows.size(), 30);
    squares += std::pow(mean(rows) - expected, 2);
    ++count;
  };
  for (const Box& box : {Box{20, 260, 490}, Box{40, 322, 435}, Box{60, 240, 312}, Box{80, 240, 288}}) {
    const auto stripes = find_laser_stripes(read(folder / fmt::format("{}cm.jpg", box.distance_cm)));
    const double expected = 255 + 1800.0 / box.distance_cm;
    compare(rows_near(stripes, expected, box.first, box.last), expected);
    compare(rows_near(stripes, 273, 0, box.first - 15), 273);
  }
  compare(rows_near(find_laser_stripes(read(folder / "1m.jpg")), 273, 0, 639), 273);
  const double rms_px = std::sqrt(squares / count);
  fmt::print("stripe rows: rms {:.2f} px against 255 + 1800/d on boxes and 273 on the wall\n", rms_px);
  EXPECT_LE(rms_px, 1.0);
}

/// The largest error of the columns where the image is brightest and darkest (L96 section 3.5).
double most_off(const std::array<double, 8>& a, const std::array<double, 8>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// Of consecutive images, every second one is taught and the others are recognised.
struct PlaceCount {
  int images = 0;
  int alike_as_published = 0;  ///< most similar to one of their neighbours, by the published views
  int alike = 0;               ///< most similar to one of their neighbours
  int sure = 0;                ///< and certain to be there
  int wrong = 0;               ///< certain, but more than three images away
  int confirmed = 0;        ///< most similar to a neighbour, and certain or confirmed by the images beside it
  int confirmed_wrong = 0;  ///< confirmed, but more than three images away
};

PlaceCount recognise_every_second(const std::vector<Image>& drive) {
  PlaceRecogniser recogniser({});
  for (std::size_t i = 0; i < drive.size(); i += 2) recogniser.teach(drive[i]);
  PlaceCount count;
  std::vector<std::size_t> places;
  std::vector<int> aways;
  std::vector<bool> sures;
  for (std::size_t i = 1; i < drive.size(); i += 2) {
    const auto view = brightness_view(drive[i]);
    std::size_t nearest = 0;
    for (std::size_t j = 0; j < drive.size(); j += 2) {
      if (most_off(view, brightness_view(drive[j])) < most_off(view, brightness_view(drive[nearest])))
        nearest = j;
    }
    count.alike_as_published += static_cast<int>(nearest + 1 == i || i + 1 == nearest);
    const auto found = recogniser.recognise(drive[i]);
    const int away = std::abs(2 * static_cast<int>(found->view) - static_cast<int>(i));
    const bool is_sure = recogniser.is_sure(*found);
    ++count.images;
    count.alike += static_cast<int>(away == 1);
    count.sure += static_cast<int>(away == 1 && is_sure);
    count.wrong += static_cast<int>(away > 3 && is_sure);
    places.push_back(found->view);
    aways.push_back(away);
    sures.push_back(is_sure);
  }
  const std::vector<bool> confirmed = recogniser.confirmed(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    count.confirmed += static_cast<int>(aways[i] == 1 && (sures[i] || confirmed[i]));
    count.confirmed_wrong += static_cast<int>(aways[i] > 3 && confirmed[i]);
  }
  return count;
}

void print(const char* of, const PlaceCount& count) {
  fmt::print(
      "places, every second image of {} taught: of {} most like a neighbour {} (as published {}), sure of "
      "it {}, "
      "with those confirmed {}; sure of a wrong place {}, confirmed {}\n",
      of, count.images, count.alike, count.alike_as_published, count.sure, count.confirmed, count.wrong,
      count.confirmed_wrong);
}

TEST(RealImages, PlacesOfACorridorAreRecognisedFromMetresAway) {
  const fs::path folder = images("rtabmap_corridor_2laps");
  AISLE_NEEDS(folder);
  std::vector<Image> lap;
  for (int i = 1; i <= 40; ++i) lap.push_back(read(folder / fmt::format("{}.jpg", i)));
  PlaceRecogniser whole({});
  for (const Image& image : lap) whole.teach(image);
  for (std::size_t i = 0; i < lap.size(); ++i) EXPECT_EQ(whole.recognise(lap[i])->view, i);
  const PlaceCount count = recognise_every_second(lap);
  print("a lap", count);
  EXPECT_GE(count.alike, 12);
  EXPECT_EQ(count.wrong, 0);
  EXPECT_EQ(count.confirmed_wrong, 0);
}

TEST(RealImages, PlacesOfAnOfficeAreRecognised) {
  const fs::path folder = images("pepper_office");
  AISLE_NEEDS(folder);
  std::vector<Image> drive;
  for (int i = 0; i <= 320; i += 4) drive.push_back(read(folder / fmt::format("img{:05}.png", i)));
  const PlaceCount count = recognise_every_second(drive);
  print("a drive", count);
  EXPECT_GE(count.sure, 34);
  EXPECT_EQ(count.wrong, 0);
  EXPECT_EQ(count.confirmed_wrong, 0);
}

ViewCheck check_of(const std::vector<fs::path>& files) {
  ImageExaminer examiner;
  std::vector<ImageEvidence> evidence;
  evidence.reserve(files.size());
  for (const fs::path& file : files) evidence.push_back(examiner.examine(read(file)));
  return check_views(evidence, {}, false);
}

void print(const char* of, const ViewCheck& check) {
  fmt::print("check of {}: wall-floor edges {} of {}, verticals {}, floor points {}, free floor {}\n", of,
             check.edges.good, check.edges.images, check.verticals.good, check.floor_points.good,
             check.floor.good);
}

TEST(RealImages, TheCheckSaysWhereTheEdgesAreThatWereMarked) {
  const fs::path folder = images("office_corridor_walkable");
  AISLE_NEEDS(folder);
  const ViewCheck check = check_of(jpegs_in(folder));
  print("a corridor", check);
  EXPECT_EQ(check.sections.verdict, ViewVerdict::kSeen);
  EXPECT_EQ(check.verticals.verdict, ViewVerdict::kSeen);
  ASSERT_TRUE(check.medians.horizon);
  EXPECT_NEAR(*check.medians.horizon, 0.5, 0.03);
}

TEST(RealImages, TheCheckSaysThatAMirroringFloorIsNotSeen) {
  const fs::path folder = images("rtabmap_corridor_2laps");
  AISLE_NEEDS(folder);
  const ViewCheck check = check_of(images_in_folder(folder));
  print("a corridor with a polished floor", check);
  EXPECT_EQ(check.rooms.verdict, ViewVerdict::kNotSeen);
  EXPECT_EQ(check.verticals.verdict, ViewVerdict::kSeen);
  EXPECT_THAT(check.hints, testing::Contains(ViewHint::kLooksUp));
  EXPECT_THAT(check.hints, testing::Contains(ViewHint::kFloorUnclear));
}

TEST(RealImages, TheCheckSeesTheLabelledFloorOfRooms) {
  const fs::path folder = images("hedau_layout");
  AISLE_NEEDS(folder);
  const ViewCheck check = check_of(jpegs_in(folder / "room"));
  print("rooms", check);
  EXPECT_EQ(check.rooms.verdict, ViewVerdict::kSeen);
  EXPECT_EQ(check.floor.good, 10) << "of one room the floor is found with an overlap of 0.37";
}

TEST(RealImages, TheCheckSeesNoCorridorWhereThereIsNone) {
  const fs::path folder = images("chessboard_opencv");
  AISLE_NEEDS(folder);
  const ViewCheck check = check_of(jpegs_in(folder));
  print("chessboards held into a camera", check);
  EXPECT_EQ(check.sections.verdict, ViewVerdict::kNotSeen);
  EXPECT_EQ(check.landmarks.verdict, ViewVerdict::kNotSeen);
}

}  // namespace
}  // namespace aisle
