#include "image_sequences/image_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aisle/core/median.hpp"
#include "aisle/formats/whole_file.hpp"
#include "image_sequences/usable_images.hpp"

namespace aisle {
namespace {

constexpr std::size_t kFileBytesMax = std::size_t{64} << 20;
constexpr double kPause_s = 5;

Result<UsableImage> read_usable(const std::filesystem::path& file) {
  const auto bytes = read_whole_file(file, kFileBytesMax);
  if (!bytes) return bytes.problems();
  return usable_file(*bytes, file.string());
}

std::vector<double> steps_of(const std::vector<ListedImage>& images) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < images.size(); ++i)
    steps_s.push_back(images[i].stamp_s - images[i - 1].stamp_s);
  return steps_s;
}

/// Pauses are part of a session's duration, so they are mentioned.
std::optional<Problem> pauses_in(const std::vector<double>& steps_s, const std::string& recording) {
  const auto pauses = std::count_if(steps_s.begin(), steps_s.end(), [](double s) { return s > kPause_s; });
  if (pauses == 0) return std::nullopt;
  return Problem{
      {recording},
      fmt::format("has pauses of more than {:g} s ({}, the longest of {:.0f} s): it may be several "
                  "recordings in one, and aisle cut takes a part",
                  kPause_s, pauses, *std::max_element(steps_s.begin(), steps_s.end()))};
}

class ListedSequence final : public UsableImages {
 public:
  explicit ListedSequence(ImageList list) : UsableImages(list.recording.string()), list_(std::move(list)) {
    const std::vector<double> steps_s = steps_of(list_.images);
    if (!steps_s.empty()) period_s_ = median(steps_s);
    for (const Problem& warning : list_.warnings) warn(warning);
    if (auto pauses = pauses_in(steps_s, list_.recording.string())) warn(std::move(*pauses));
    leave_out("record", list_.unreadable);
  }

  bool has_odometry() const override { return list_.has_odometry; }
  double period_s() const override { return period_s_; }
  std::size_t size() const override { return list_.images.size(); }

 private:
  Result<std::optional<Candidate>> next_candidate() override {
    while (at_ < list_.images.size()) {
      const ListedImage& listed = list_.images[at_++];
      std::error_code error;
      if (!std::filesystem::is_regular_file(listed.file, error)) {
        leave_out("missing image", {{listed.file.string()}, "no such file"});
      } else if (auto usable = read_usable(listed.file); !usable) {
        leave_out("damaged image", usable.problems().front());
      } else {
        return std::optional(Candidate{{.stamp_s = listed.stamp_s,
                                        .bytes = {},
                                        .T_odom_vehicle = listed.T_odom_vehicle,
                                        .controls = listed.controls},
                                       std::move(*usable),
                                       {listed.file.string()}});
      }
    }
    return std::optional<Candidate>();
  }

  ImageList list_;
  double period_s_ = 0;
  std::size_t at_ = 0;
};

}  // namespace

Result<std::unique_ptr<ImageSequence>> sequence_of(ImageList list) {
  auto sequence = std::make_unique<ListedSequence>(std::move(list));
  if (Problems problems = sequence->begin(); !problems.empty()) return problems;
  return std::unique_ptr<ImageSequence>(std::move(sequence));
}

}  // namespace aisle
