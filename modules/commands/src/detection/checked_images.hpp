#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/check_images.hpp"
#include "aisle/core/image.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"

namespace aisle {

/// An image that is looked at.
struct CheckedImage {
  std::string name;  ///< its path; of a recording "RECORDING#NUMBER", from 0
  Image image;
  bool is_next = false;  ///< it was taken right after the one before
};

/// Which of `all` images are looked at: all, or evenly spread pairs of images in a row, `most` in all.
/// Sorted.
std::vector<bool> evenly_chosen(std::size_t all, std::size_t most);

/// The images to look at, from everything that the user named, in order.
class CheckedImages {
 public:
  /// All that is wrong with the recordings, at once.
  static Result<CheckedImages> open(const CheckImagesOptions& options);

  /// How many there are, and how many of them will be looked at.
  std::size_t size() const { return wanted_.size(); }
  std::size_t wanted() const;
  /// The lens, if the recordings have one and it is one.
  std::optional<CameraIntrinsics> lens() const;

  /// @return nullopt after the last
  Result<std::optional<CheckedImage>> next();
  /// How many images were passed so far, looked at or not.
  std::size_t passed() const { return passed_; }
  std::size_t left_out() const;
  /// What was left out, each with its first place.
  Problems warnings() const;

 private:
  /// One of the recordings: files, or a sequence.
  struct Source {
    std::string name;
    std::vector<std::filesystem::path> files;
    bool is_named = false;  ///< the file itself, not a folder with it
    std::unique_ptr<ImageSequence> sequence;

    std::size_t size() const { return sequence ? sequence->size() : files.size(); }
  };

  static Result<Source> source_of(const std::string& recording, const CheckImagesOptions& options);
  Result<std::optional<CheckedImage>> next_of(Source& source);
  void leave_out(const Problems& why);

  std::vector<Source> sources_;
  std::vector<bool> wanted_;
  std::size_t source_ = 0;     // the present one
  std::size_t in_source_ = 0;  // images of it that were passed
  std::size_t passed_ = 0;
  std::optional<std::size_t> last_;  // the image that was returned last, as a number among all
  std::size_t unreadable_ = 0;
  Problems first_unreadable_;
};

}  // namespace aisle
