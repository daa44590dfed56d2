#include "image_sequences/bag_images.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "aisle/core/median.hpp"
#include "aisle/formats/bags/bag_camera.hpp"
#include "aisle/formats/bags/bag_image.hpp"
#include "aisle/vehicle/odometry_track.hpp"
#include "bags/bag_recording.hpp"
#include "image_sequences/stamp_order.hpp"
#include "image_sequences/usable_images.hpp"

namespace aisle {
namespace {

constexpr double kBesideOdometry_s = 0.5;

/// An image that is still in the bag.
struct StampedImage {
  long number = 0;  ///< of its message
  double stamp_s = 0;
  std::optional<Pose2> T_odom_vehicle;
};

/// Each image with the pose at its time.
std::vector<StampedImage> stamped_images(BagRecording& recording, const std::string& file) {
  const std::vector<OdometrySample>& samples = recording.lasers.log.odometry;
  std::vector<StampedImage> stamped;
  std::size_t beside = 0;
  for (std::size_t i = 0; i < recording.image_times_s.size(); ++i) {
    const double stamp_s = recording.image_times_s[i];
    stamped.push_back({recording.images.times[i].number, stamp_s, {}});
    if (samples.empty()) continue;
    stamped.back().T_odom_vehicle = OdometryTrack(samples).at(stamp_s, samples.size());
    if (stamp_s < samples.front().time_s - kBesideOdometry_s ||
        stamp_s > samples.back().time_s + kBesideOdometry_s)
      ++beside;
  }
  if (beside > 0)
    recording.lasers.warnings.push_back(
        {{file},
         fmt::format("{} of {} images were taken before the odometry begins or after it ends: there the "
                     "vehicle is taken to stand",
                     beside, stamped.size())});
  return stamped;
}

class BagImageSequence final : public UsableImages {
 public:
  BagImageSequence(BagReader bag, std::size_t topic, std::vector<StampedImage> images, std::string file)
      : UsableImages(file),
        bag_(std::move(bag)),
        topic_(topic),
        images_(std::move(images)),
        file_(std::move(file)) {
    bag_.want({topic_});
  }

  void set_camera(RecordedCamera camera) { camera_ = std::move(camera); }
  void set_scans(LaserRecording scans) { scans_ = std::move(scans); }
  using UsableImages::warn;

  bool has_odometry() const override { return !images_.empty() && images_.front().T_odom_vehicle; }
  RecordedCamera camera() const override { return camera_; }
  std::optional<LaserRecording> take_scans() override { return std::exchange(scans_, std::nullopt); }
  double period_s() const override;
  std::size_t size() const override { return images_.size(); }
  Problems warnings() const override {
    Problems warnings = bag_.warnings();
    for (Problem& warning : UsableImages::warnings()) warnings.push_back(std::move(warning));
    return warnings;
  }

 private:
  Result<std::optional<Candidate>> next_candidate() override {
    while (at_ < images_.size()) {
      const auto message = bag_.next();
      if (!message) return message.problems();
      if (!*message) break;
      if ((*message)->number != images_[at_].number) continue;  // one whose header could not be read
      const StampedImage& image = images_[at_++];
      const Place place{file_, image.number, topic().name};
      if (!(image.stamp_s >= before_s_ + kStampStepMin_s && image.stamp_s <= kStampMax_s)) {
        leave_out("image", {place, fmt::format("has the stamp {:.6f} s, not later than the image before",
                                               image.stamp_s)});
      } else if (auto usable = decoded((*message)->bytes, place); !usable) {
        leave_out("damaged image", usable.problems().front());
      } else {
        before_s_ = image.stamp_s;
        return std::optional(Candidate{
            {.stamp_s = image.stamp_s, .bytes = {}, .T_odom_vehicle = image.T_odom_vehicle, .controls = {}},
            std::move(*usable),
            place});
      }
    }
    return std::optional<Candidate>();
  }

  Result<UsableImage> decoded(std::string_view bytes, const Place& place) const {
    const auto image = bag_image(bytes, topic().type, topic().encoding, place);
    if (!image) return image.problems();
    return usable(image->pixels, image->file, to_string(Problem{place, "an image"}));
  }

  const BagTopic& topic() const { return bag_.topics()[topic_]; }

  BagReader bag_;
  std::size_t topic_;
  std::vector<StampedImage> images_;
  std::string file_;
  RecordedCamera camera_;
  std::optional<LaserRecording> scans_;
  std::size_t at_ = 0;
  double before_s_ = -kStampStepMin_s;
};

double BagImageSequence::period_s() const {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < images_.size(); ++i)
    steps_s.push_back(images_[i].stamp_s - images_[i - 1].stamp_s);
  return steps_s.empty() ? 0 : median(std::move(steps_s));
}

}  // namespace

Result<std::unique_ptr<ImageSequence>> open_bag_images(const std::filesystem::path& path,
                                                       const ImageSequenceOptions& options) {
  const std::string file = path.string();
  if (options.rate_hz) return Problem{{file}, "has stamps: --image-rate is for images that have none"};
  auto bag = BagReader::open(path);
  if (!bag) return bag.problems();
  Problems choices;
  const auto choice = choose_image_topics(*bag, options.topic, options.reading, file, choices);
  if (!choice) return choice.problems();
  const std::string topic = bag->topics()[*choice->images].name;
  auto recording = read_bag_recording(*bag, *choice, options.reading, file);
  if (!recording) return recording.problems();
  auto images = stamped_images(*recording, file);
  auto sequence =
      std::make_unique<BagImageSequence>(std::move(*bag), *choice->images, std::move(images), file);
  if (Problems problems = sequence->begin(); !problems.empty()) return problems;
  Problems warnings = std::exchange(recording->lasers.warnings, {});
  if (!sequence->has_odometry())
    warnings.push_back({{file},
                        "has no odometry: nothing that needs it, such as aisle learn, works with this "
                        "recording"});
  const Problem about_camera{{file, 0, topic}, {}};
  std::optional<CameraIntrinsics> lens;
  if (const auto& info = recording->images.calibration)
    lens = bag_lens(*info, topic, sequence->width_px(), sequence->height_px(), about_camera, warnings);
  sequence->set_camera(
      {topic, lens,
       bag_mount(recording->transforms, recording->base, recording->images.frame, about_camera, warnings)});
  if (!choice->scans.empty()) sequence->set_scans(std::move(recording->lasers));
  for (Problem& warning : choices) sequence->warn(std::move(warning));
  for (Problem& warning : warnings) sequence->warn(std::move(warning));
  return std::unique_ptr<ImageSequence>(std::move(sequence));
}

}  // namespace aisle
