#include "logs/mrpt_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace aisle {
namespace {

constexpr std::size_t kClassNameMax = 100;

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':';
}

}  // namespace

bool MrptStream::take(std::size_t count) {
  if (!ok()) return false;
  if (count > bytes_.size() - position_) {
    is_cut_off_ = true;
    fail("the file is cut off here");
    return false;
  }
  position_ += count;
  return true;
}

void MrptStream::fail(std::string what) {
  if (ok()) failure_ = std::move(what);
}

void MrptStream::forget_failure() {
  failure_.clear();
  is_cut_off_ = false;
}

bool MrptStream::is_at_end_flag() const {
  return !is_at_end() && static_cast<unsigned char>(bytes_[position_]) == kMrptEndOfObject;
}

std::string_view MrptStream::read_string() {
  return read_bytes(read<std::uint32_t>());
}

std::string_view MrptStream::read_bytes(std::size_t count) {
  return take(count) ? bytes_.substr(position_ - count, count) : std::string_view();
}

std::optional<MrptHeader> MrptStream::header_at(std::size_t position) const {
  if (position >= bytes_.size()) return std::nullopt;
  const auto first = static_cast<unsigned char>(bytes_[position]);
  const std::size_t length = first & 0x7fU;
  if ((first & 0x80U) == 0 || length == 0 || length > kClassNameMax) return std::nullopt;
  if (length + 1 >= bytes_.size() - position) return std::nullopt;
  const std::string_view name = bytes_.substr(position + 1, length);
  if (!std::all_of(name.begin(), name.end(), is_name_character)) return std::nullopt;
  const std::size_t colon = name.rfind(':');
  return MrptHeader{colon == std::string_view::npos ? name : name.substr(colon + 1),
                    static_cast<unsigned char>(bytes_[position + 1 + length])};
}

MrptHeader MrptStream::read_header() {
  if (!ok()) return {};
  const std::optional<MrptHeader> header = header_at(position_);
  if (!header) {
    const unsigned first = is_at_end() ? 0x80U : static_cast<unsigned char>(bytes_[position_]);
    is_cut_off_ = (first & 0x80U) != 0 && 2 + (first & 0x7fU) > bytes_.size() - position_;
    fail(is_cut_off_ ? "the file is cut off here" : "no object begins here");
    return {};
  }
  take(2 + (static_cast<unsigned char>(bytes_[position_]) & 0x7fU));
  return *header;
}

int MrptStream::read_header_of(std::string_view class_name, int latest_version) {
  const MrptHeader header = read_header();
  if (!ok()) return 0;
  if (header.class_name != class_name) {
    fail(fmt::format("has a {} where a {} should be", header.class_name, class_name));
  } else if (header.version > latest_version) {
    fail(fmt::format("has a {} of version {}; versions 0 to {} are known", class_name, header.version,
                     latest_version));
  }
  return header.version;
}

void MrptStream::read_end_of_object() {
  if (read<unsigned char>() != kMrptEndOfObject && ok()) fail("an object does not end where it should");
}

bool MrptStream::seek_next_record() {
  for (std::size_t position = position_; position < bytes_.size(); ++position) {
    const std::optional<MrptHeader> header = header_at(position);
    if (!header || !is_rawlog_record(header->class_name)) continue;
    position_ = position;
    return true;
  }
  return false;
}

bool is_rawlog_record(std::string_view class_name) {
  return class_name.starts_with("CObservation") || class_name.starts_with("CActionCollection") ||
         class_name.starts_with("CActionRobotMovement") || class_name == "CSensoryFrame";
}

bool begins_rawlog(std::string_view head) {
  const MrptHeader header = MrptStream(head).read_header();
  return header.class_name.starts_with("CObservation") || header.class_name.starts_with("CAction") ||
         header.class_name == "CSensoryFrame" || header.class_name == "CRawlog";
}

}  // namespace aisle
