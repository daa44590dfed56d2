#include "folder_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "aisle/formats/images/image_file.hpp"

namespace aisle {
namespace {

Result<std::unique_ptr<ImageSequence>> opened_sequence(const CameraSource& source) {
  return open_image_sequence(source.folder, {.rate_hz = source.rate_hz, .front_steered = {}});
}

Image in_colour(Image image) {
  if (image.channels == 3) return image;
  Image colour(image.width_px, image.height_px, 3);
  for (std::size_t i = 0; i < image.bytes.size(); ++i)
    std::fill_n(colour.bytes.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, image.bytes[i]);
  return colour;
}

void sleep(double duration_s) {
  std::this_thread::sleep_for(std::chrono::duration<double>(duration_s));
}

}  // namespace

Result<std::unique_ptr<ImageStream>> FolderStream::open(const CameraSource& source) {
  auto sequence = opened_sequence(source);
  if (!sequence) return sequence.problems();
  return std::unique_ptr<ImageStream>(new FolderStream(source, std::move(*sequence)));
}

FolderStream::FolderStream(const CameraSource& source, std::unique_ptr<ImageSequence> sequence)
    : source_(source), sequence_(std::move(sequence)) {}

void FolderStream::start() {
  due_s_ = clock_.now_s();
}

StreamNews FolderStream::wait(double longest_s) {
  if (sequence_->left_out() > left_out_) {
    left_out_ = sequence_->left_out();
    return RefusedImage{to_string(sequence_->warnings().back())};
  }
  const double wait_s = due_s_ - clock_.now_s();
  sleep(std::min(wait_s, longest_s));
  if (wait_s > longest_s) return NothingYet{};
  return next_image();
}

StreamNews FolderStream::next_image() {
  auto timed = sequence_->next();
  if (!timed) return StreamEnd{to_string(timed.problems())};
  if (!timed->has_value()) return begin_again();
  auto pixels = parse_image((*timed)->bytes, source_.folder);
  if (!pixels) return RefusedImage{to_string(pixels.problems())};
  ++shown_;
  const double stamp_s = due_s_;
  due_s_ = std::max(due_s_ + 1 / source_.rate_hz, clock_.now_s());
  return StreamedImage{source_.is_colour ? in_colour(std::move(*pixels)) : to_grey(*pixels), stamp_s};
}

StreamNews FolderStream::begin_again() {
  if (!source_.loops) {
    return StreamEnd{.why = fmt::format("all {} images were shown, {} left out", shown_, left_out_),
                     .is_final = true};
  }
  auto sequence = opened_sequence(source_);
  if (!sequence) return StreamEnd{to_string(sequence.problems())};
  sequence_ = std::move(*sequence);
  left_out_ = 0;
  return NothingYet{};
}

}  // namespace aisle
