/// Detectors on labelled images of others, leave one set out: the parameters that matter are chosen on all
/// sets but one and measured on that one, beside the defaults. Then the same for what `aisle detect --check`
/// says of each image, which must agree with what was measured. AISLE_DATA, or the first argument, is the
/// data's folder.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "aisle/formats/images/image_file.hpp"
#include "aisle/vision/check/view_check.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

constexpr double kOfWidth_px = 640;     // errors are stated in pixels of images so wide
constexpr double kRightEdge_px = 2;     // an edge is right so near
constexpr double kSameVertical_px = 3;  // a line is found so near
constexpr double kRightOverlap = 0.75;  // a floor region is right from this IoU on

Image read(const fs::path& path) {
  auto image = read_image(path);
  if (!image) throw std::runtime_error(to_string(image.problems()));
  return std::move(*image);
}

/// The folder of an image, which is the set that it belongs to.
std::string set_of(const std::string& image) {
  return fs::path(image).parent_path().string();
}

// ---- labels -------------------------------------------------------------------------------------------

struct LabelledFloor {
  std::string name;
  Image image;
  Image floor;  ///< 255: visible floor
};

struct LabelledEdge {
  std::string name;
  Image image;
  std::vector<Vec2> right_px;  ///< points of the right wall-floor edge from far to near
};

struct Vertical {
  Vec2 top_px, bottom_px;
};

struct LabelledVerticals {
  std::string name;
  Image image;
  std::vector<Vertical> lines;   ///< that must be found
  std::vector<Vertical> others;  ///< that may be: true, but faint, short or beside another
};

template <class Labelled>
using Sets = std::map<std::string, std::vector<Labelled>>;

Image grey_of_label(const fs::path& file) {
  Image mask = to_grey(read(file));
  for (std::uint8_t& byte : mask.bytes) byte = byte > 127 ? 255 : 0;
  return mask;
}

Sets<LabelledFloor> labelled_floors(const fs::path& images) {
  Sets<LabelledFloor> sets;
  for (const char* set : {"hedau_layout/corridor", "hedau_layout/room"}) {
    for (const auto& entry : fs::directory_iterator(images / set)) {
      if (entry.path().extension() != ".jpg") continue;
      const fs::path mask = images / set / (entry.path().stem().string() + "_floorvisible.png");
      sets[set].push_back({entry.path().filename().string(), read(entry.path()), grey_of_label(mask)});
    }
  }
  for (const char* number : {"0050", "0700"}) {
    const fs::path folder = images / "cmu_popup_corridor";
    sets["cmu_popup_corridor"].push_back({number, read(folder / fmt::format("rgb_{}.png", number)),
                                          grey_of_label(folder / fmt::format("label_{}.png", number))});
  }
  return sets;
}

std::ifstream labels_file(const char* name) {
  return std::ifstream(fs::path(AISLE_SOURCE_DIR) / "tests" / "data" / name);
}

Sets<LabelledEdge> labelled_edges(const fs::path& images) {
  Sets<LabelledEdge> sets;
  std::ifstream file = labels_file("right_base_lines.txt");
  for (std::string text; std::getline(file, text);) {
    std::istringstream words(text);
    std::string name;
    words >> name;
    LabelledEdge& edge = sets[set_of(name)].emplace_back();
    edge.name = name;
    edge.image = read(images / name);
    for (double u = 0, v = 0; words >> u >> v;) edge.right_px.emplace_back(u, v);
  }
  return sets;
}

Sets<LabelledVerticals> labelled_verticals(const fs::path& images) {
  Sets<LabelledVerticals> sets;
  std::ifstream file = labels_file("vertical_lines.txt");
  std::string name, kind;
  for (Vertical line; file >> name >> kind >> line.top_px.x() >> line.top_px.y() >> line.bottom_px.x() >>
                      line.bottom_px.y();) {
    auto& set = sets[set_of(name)];
    if (set.empty() || set.back().name != name) set.push_back({name, read(images / name), {}, {}});
    (kind == "line" ? set.back().lines : set.back().others).push_back(line);
  }
  return sets;
}

// ---- measures -----------------------------------------------------------------------------------------

double overlap(const Image& a, const Image& b) {
  std::size_t both = 0, either = 0;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) {
    both += static_cast<std::size_t>(a.bytes[i] != 0 && b.bytes[i] != 0);
    either += static_cast<std::size_t>(a.bytes[i] != 0 || b.bytes[i] != 0);
  }
  return static_cast<double>(both) / static_cast<double>(std::max<std::size_t>(1, either));
}

double distance_px(const BaseLine& line, const Vec2& p) {
  const Vec2 along = (line.back() - line.front()).normalized();
  return std::abs(left_normal(along).dot(p - line.front()));
}

/// Mean distance of a labelled edge from what was found [px of 640]; nullopt: nothing was.
std::optional<double> off_px(const LabelledEdge& label, const std::optional<BaseLine>& found) {
  if (!found) return std::nullopt;
  constexpr int kEvery = 20;
  double sum = 0, length_px = 0;
  for (std::size_t i = 1; i < label.right_px.size(); ++i) {
    const Vec2 piece = label.right_px[i] - label.right_px[i - 1];
    for (int k = 0; k < kEvery; ++k)
      sum += piece.norm() / kEvery * distance_px(*found, label.right_px[i - 1] + (k + 0.5) / kEvery * piece);
    length_px += piece.norm();
  }
  return sum / length_px * kOfWidth_px / label.image.width_px;
}

double column_at(const Vec2& top, const Vec2& bottom, double row) {
  return top.x() + (row - top.y()) / (bottom.y() - top.y()) * (bottom.x() - top.x());
}

/// Whether two lines are one: side by side over three tenths of the shorter one, and near there.
bool is_the_same(const Vertical& label, const VerticalLine& found, int width_px) {
  const double from = std::max(label.top_px.y(), found.top_px.y());
  const double to = std::min(label.bottom_px.y(), found.bottom_px.y());
  const double shorter =
      std::min(label.bottom_px.y() - label.top_px.y(), found.bottom_px.y() - found.top_px.y());
  if (to - from < 0.3 * shorter) return false;
  const double row = (from + to) / 2;
  const double apart_px =
      std::abs(column_at(label.top_px, label.bottom_px, row) - column_at(found.top_px, found.bottom_px, row));
  return apart_px * kOfWidth_px / width_px <= kSameVertical_px;
}

struct Counted {
  int due = 0, found = 0;  ///< labelled lines that must be found, and those that were
  int detected = 0;        ///< lines that were found
  int of_due = 0;          ///< of these, on a line that must be found
  int right = 0;           ///< of these, on any labelled line

  double recall() const { return static_cast<double>(found) / std::max(1, due); }
  double strict_precision() const { return static_cast<double>(of_due) / std::max(1, detected); }
  double precision() const { return static_cast<double>(right) / std::max(1, detected); }
  std::string words() const {
    return fmt::format("recall {:.2f} of {}, precision {:.2f}, with all true lines {:.2f}, of {}", recall(),
                       due, strict_precision(), precision(), detected);
  }
  Counted& operator+=(const Counted& other) {
    due += other.due;
    found += other.found;
    detected += other.detected;
    of_due += other.of_due;
    right += other.right;
    return *this;
  }
};

Counted count(const LabelledVerticals& label, const std::vector<VerticalLine>& lines) {
  const auto is_any = [&](const std::vector<Vertical>& labels, const VerticalLine& line) {
    return std::any_of(labels.begin(), labels.end(), [&](const Vertical& vertical) {
      return is_the_same(vertical, line, label.image.width_px);
    });
  };
  Counted counted;
  for (const Vertical& vertical : label.lines) {
    ++counted.due;
    counted.found += static_cast<int>(std::any_of(lines.begin(), lines.end(), [&](const VerticalLine& line) {
      return is_the_same(vertical, line, label.image.width_px);
    }));
  }
  for (const VerticalLine& line : lines) {
    ++counted.detected;
    counted.of_due += static_cast<int>(is_any(label.lines, line));
    counted.right += static_cast<int>(is_any(label.lines, line) || is_any(label.others, line));
  }
  return counted;
}

// ---- leave one out ------------------------------------------------------------------------------------

/// How good a setting is on a set, and in words.
struct Score {
  double value = 0;
  std::string words;
};

/// Scores of every setting on every set; the first setting is the defaults'.
struct Scores {
  std::vector<std::string> settings, sets;
  std::vector<std::vector<Score>> of;  ///< [setting][set]

  /// The setting that is best on average over all sets but one; the earliest of equals.
  std::size_t best_without(std::size_t left_out) const {
    std::size_t best = 0;
    double most = -1e9;
    for (std::size_t s = 0; s < settings.size(); ++s) {
      double sum = 0;
      for (std::size_t k = 0; k < sets.size(); ++k) sum += k == left_out ? 0 : of[s][k].value;
      if (sum > most + 1e-9) {
        most = sum;
        best = s;
      }
    }
    return best;
  }
};

template <class Labelled, class Setting>
Scores scores_of(const Sets<Labelled>& sets, const std::vector<std::pair<std::string, Setting>>& settings,
                 const std::function<Score(const std::vector<Labelled>&, const Setting&)>& score) {
  Scores scores;
  for (const auto& [name, set] : sets) scores.sets.push_back(name);
  for (const auto& [name, setting] : settings) {
    scores.settings.push_back(name);
    auto& row = scores.of.emplace_back();
    for (const auto& [set_name, set] : sets) row.push_back(score(set, setting));
  }
  return scores;
}

void print_left_out(const char* title, const Scores& scores) {
  fmt::print(
      "\n{}: chosen among {} settings\n| left out | by the choice on the others | by the defaults | chosen "
      "|\n"
      "|---|---|---|---|\n",
      title, scores.settings.size());
  for (std::size_t k = 0; k < scores.sets.size(); ++k) {
    const std::size_t chosen = scores.best_without(k);
    fmt::print("| {} | {} | {} | {} |\n", scores.sets[k], scores.of[chosen][k].words, scores.of[0][k].words,
               scores.settings[chosen]);
  }
  const std::size_t best = scores.best_without(scores.sets.size());
  fmt::print("best on all sets together: {}\n", scores.settings[best]);
}

// ---- the three features -------------------------------------------------------------------------------

void measure_floor(const fs::path& images) {
  std::vector<std::pair<std::string, RegionParams>> settings{{"defaults", {}}};
  for (const double floor_cost : {160., 120., 220.})
    for (const double rest_cost : {400., 300., 550.})
      for (const double texture_factor : {1.5, 1., 2.})
        for (const double colour_weight : {2., 1.}) {
          RegionParams params;
          params.floor_cost = floor_cost;
          params.rest_cost = rest_cost;
          params.texture_factor = texture_factor;
          params.colour_weight = colour_weight;
          settings.emplace_back(
              fmt::format("floor_cost {:g}, rest_cost {:g}, texture_factor {:g}, colour_weight {:g}",
                          floor_cost, rest_cost, texture_factor, colour_weight),
              params);
        }
  const auto score = [](const std::vector<LabelledFloor>& set, const RegionParams& params) -> Score {
    double sum = 0, least = 1;
    for (const LabelledFloor& label : set) {
      const double iou = overlap(find_route_region(label.image, params).mask, label.floor);
      sum += iou;
      least = std::min(least, iou);
    }
    const double mean = sum / static_cast<double>(set.size());
    return {mean, fmt::format("IoU {:.3f}, least {:.2f} of {}", mean, least, set.size())};
  };
  print_left_out("free floor",
                 scores_of<LabelledFloor, RegionParams>(labelled_floors(images), settings, score));
}

void measure_edges(const fs::path& images) {
  std::vector<std::pair<std::string, LineFinderParams>> settings{{"defaults", {}}};
  for (const double score_min : {0.11, 0.05, 0.08, 0.15, 0.2})
    for (const int width_px : {640, 480, 800}) {
      LineFinderParams params;
      params.base_lines.score_min = score_min;
      params.base_lines.width_max_px = width_px;
      settings.emplace_back(fmt::format("score_min {:g}, width_max_px {}", score_min, width_px), params);
    }
  const auto score = [](const std::vector<LabelledEdge>& set, const LineFinderParams& params) -> Score {
    LineFinder finder(params);
    int right = 0;
    std::vector<double> offs_px;
    for (const LabelledEdge& label : set) {
      const auto off = off_px(label, finder.find(label.image).base_lines.right);
      if (off) offs_px.push_back(*off);
      right += static_cast<int>(off && *off <= kRightEdge_px);
    }
    double mean_px = 0;
    for (const double off : offs_px) mean_px += off / static_cast<double>(offs_px.size());
    return {static_cast<double>(right) / static_cast<double>(set.size()),
            fmt::format("{} of {} within 2 px, {} missed, mean {:.2f} px", right, set.size(),
                        set.size() - offs_px.size(), mean_px)};
  };
  print_left_out("right wall-floor edge",
                 scores_of<LabelledEdge, LineFinderParams>(labelled_edges(images), settings, score));
}

void measure_verticals(const fs::path& images) {
  std::vector<std::pair<std::string, LineFinderParams>> settings{{"defaults", {}}};
  for (const double score_min : {0.35, 0.2, 0.24, 0.28, 0.32, 0.4})
    for (const double usual_score_min : {0.7, 0.5, 0.9})
      for (const double fill_min : {0.6, 0.5, 0.7})
        for (const double contrast_min : {3.5, 5.}) {
          LineFinderParams params;
          params.verticals.score_min = score_min;
          params.verticals.usual_score_min = usual_score_min;
          params.verticals.fill_min = fill_min;
          params.verticals.contrast_min = contrast_min;
          settings.emplace_back(
              fmt::format("score_min {:g}, usual_score_min {:g}, fill_min {:g}, contrast_min {:g}", score_min,
                          usual_score_min, fill_min, contrast_min),
              params);
        }
  const auto sets = labelled_verticals(images);
  for (const auto precision : {&Counted::strict_precision, &Counted::precision}) {
    const auto score = [&](const std::vector<LabelledVerticals>& set,
                           const LineFinderParams& params) -> Score {
      LineFinder finder(params);
      Counted counted;
      for (const LabelledVerticals& label : set) counted += count(label, finder.find(label.image).verticals);
      // Recall is wanted as long as half of what is found is right.
      return {counted.recall() - 2 * std::max(0.0, 0.5 - (counted.*precision)()), counted.words()};
    };
    print_left_out(
        precision == &Counted::precision ? "vertical lines, all true ones are right" : "vertical lines",
        scores_of<LabelledVerticals, LineFinderParams>(sets, settings, score));
  }
  Counted all;
  LineFinder finder;
  for (const auto& [name, set] : sets)
    for (const LabelledVerticals& label : set) all += count(label, finder.find(label.image).verticals);
  fmt::print("by the defaults on all: {}\n", all.words());
}

// ---- what the check says ------------------------------------------------------------------------------

/// An image as the check sees it, and whether the feature was measured right in it.
struct CheckedView {
  ImageEvidence evidence;
  bool is_right = false;
};

/// Agreement of the check's flags with what was measured; of a set whose images are all right, only flags
/// count.
Score agreement(const std::vector<CheckedView>& set, const ViewCheckParams& params,
                bool GoodViews::*feature) {
  std::vector<ImageEvidence> evidence;
  for (const CheckedView& view : set) evidence.push_back(view.evidence);
  const ViewCheck check = check_views(evidence, {}, false, params);
  int agree = 0, false_good = 0, good = 0, right = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const bool is_good = check.views[i].*feature;
    agree += static_cast<int>(is_good == set[i].is_right);
    false_good += static_cast<int>(is_good && !set[i].is_right);
    good += static_cast<int>(is_good);
    right += static_cast<int>(set[i].is_right);
  }
  // To call wrong what is right costs less than to call right what is wrong.
  return {(agree - false_good) / static_cast<double>(set.size()),
          fmt::format("{} of {} agree; {} called good, {} of them wrong; {} measured right", agree,
                      set.size(), good, false_good, right)};
}

/// @param feature  that the check calls good or not
void print_check_left_out(const char* title, const Sets<CheckedView>& sets,
                          const std::vector<std::pair<std::string, ViewCheckParams>>& settings,
                          bool GoodViews::*feature) {
  print_left_out(title,
                 scores_of<CheckedView, ViewCheckParams>(
                     sets, settings, [&](const std::vector<CheckedView>& set, const ViewCheckParams& params) {
                       return agreement(set, params, feature);
                     }));
}

void measure_check_of_edges(const fs::path& images) {
  Sets<CheckedView> sets;
  ImageExaminer examiner;
  for (const auto& [name, set] : labelled_edges(images)) {
    for (const LabelledEdge& label : set) {
      CheckedView view{.evidence = examiner.examine(label.image)};
      const auto off = off_px(label, examiner.lines().base_lines.right);
      view.is_right = off && *off <= kRightEdge_px;
      sets[name].push_back(view);
    }
  }
  std::vector<std::pair<std::string, ViewCheckParams>> settings{{"defaults", {}}};
  for (const double beneath : {0.4, 0., 0.7, 0.9})
    for (const double apart : {0.1, 0.05, 0.2, 1.}) {
      ViewCheckParams params;
      params.floor_beneath_min = beneath;
      params.horizon_apart_max = apart;
      settings.emplace_back(fmt::format("floor_beneath_min {:g}, horizon_apart_max {:g}", beneath, apart),
                            params);
    }
  print_check_left_out("check of the right wall-floor edge", sets, settings, &GoodViews::right_edge);
}

void measure_check_of_floor(const fs::path& images) {
  Sets<CheckedView> sets;
  ImageExaminer examiner;
  for (const auto& [name, set] : labelled_floors(images)) {
    for (const LabelledFloor& label : set) {
      CheckedView view{.evidence = examiner.examine(label.image)};
      view.is_right = overlap(examiner.floor(), label.floor) >= kRightOverlap;
      sets[name].push_back(view);
    }
  }
  std::vector<std::pair<std::string, ViewCheckParams>> settings{{"defaults", {}}};
  for (const double overlap_min : {0.65, 0., 0.5, 0.75, 0.85})
    for (const double beyond : {0.5, 0.3, 1.}) {
      ViewCheckParams params;
      params.floor_overlap_min = overlap_min;
      params.floor_beyond_max = beyond;
      settings.emplace_back(fmt::format("floor_overlap_min {:g}, floor_beyond_max {:g}", overlap_min, beyond),
                            params);
    }
  print_check_left_out("check of the free floor", sets, settings, &GoodViews::floor);
}

void measure_all(const fs::path& images) {
  measure_floor(images);
  measure_edges(images);
  measure_verticals(images);
  measure_check_of_edges(images);
  measure_check_of_floor(images);
}

}  // namespace
}  // namespace aisle

int main(int argc, char** argv) {
  const char* set = std::getenv("AISLE_DATA");
  const std::filesystem::path data = argc > 1 ? argv[1] : set != nullptr ? set : "../shared/data";
  if (!std::filesystem::exists(data / "images" / "hedau_layout")) {
    fmt::print("{} has no labelled images: nothing is measured\n", data.string());
    return 0;
  }
  aisle::measure_all(data / "images");
  return 0;
}
