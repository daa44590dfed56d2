#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/image.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "image_sequences/left_out.hpp"

namespace aisle {

/// An image that a session can store.
struct UsableImage {
  std::string bytes;  ///< of a JPEG or PNG file that can be decoded
  int width_px = 0;
  int height_px = 0;
};

/// The bytes of an image file: kept if it is JPEG or PNG, else as PNG. It is decoded once, so that no reader
/// of the session meets one that cannot be. A file that is no image, or has sides that no camera of a vehicle
/// file has, is a problem. @param name  the file's, in problems
Result<UsableImage> usable_file(std::string_view bytes, const std::string& name);

/// The same of an image that is decoded. @param file  its bytes; empty: it was never a file
Result<UsableImage> usable(const Image& image, std::string_view file, const std::string& name);

/// A sequence of the images that can be used and have the first one's size. What is left out is counted and
/// told by kinds.
class UsableImages : public ImageSequence {
 public:
  /// Finds the first usable image, which tells the size of all. A recording without one is a problem.
  Problems begin();

  int width_px() const override { return width_px_; }
  int height_px() const override { return height_px_; }
  Result<std::optional<TimedImage>> next() override;
  std::size_t left_out() const override;
  Problems warnings() const override;

 protected:
  struct Candidate {
    TimedImage image;  ///< without bytes
    UsableImage usable;
    Place place;
  };

  /// @param recording  its name
  explicit UsableImages(std::string recording) : recording_(std::move(recording)) {}

  /// The next image that can be decoded; those before it that cannot are left out.
  /// @return nullopt after the last
  virtual Result<std::optional<Candidate>> next_candidate() = 0;

  /// @param kind  in the singular: "missing image"
  void leave_out(const std::string& kind, Problem why) { left_out_[kind].add(std::move(why)); }
  void leave_out(const std::string& kind, const LeftOut& several);
  void warn(Problem warning) { warnings_.push_back(std::move(warning)); }

 private:
  Result<std::optional<TimedImage>> take();

  std::string recording_;
  int width_px_ = 0;
  int height_px_ = 0;
  std::optional<TimedImage> ahead_;
  std::map<std::string, LeftOut> left_out_;
  Problems warnings_;
};

}  // namespace aisle
