#include "aisle/formats/bags/bag_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bags/bag_files.hpp"
#include "bags/bag_store.hpp"
#include "bags/unpacking.hpp"
#include "sessions/session_files.hpp"

namespace aisle {
namespace fs = std::filesystem;

/// The files of a bag. One that is not needed yet is closed, so that neither their number nor their unpacked
/// size matters.
class BagReader::Source {
 public:
  Problems open(const fs::path& path);
  void want(const std::vector<std::size_t>& topics);
  Result<std::optional<Message>> next();
  const std::vector<BagTopic>& topics() const { return table_.topics(); }
  const Problems& warnings() const { return warnings_; }

 private:
  struct File {
    fs::path path;
    BagStore::Survey survey = {};
    long first_number = 0;                   ///< messages in the files before
    std::unique_ptr<BagStore> store = {};    ///< while it is being read
    std::optional<StoredMessage> head = {};  ///< its next message
    bool has_begun = false;
  };

  Problems survey_file(const fs::path& path);
  void order_files(bool in_recorded_order);
  /// Opens every file that begins before the messages at hand end.
  Problems open_due_files();
  Problems advance(File& file);
  File* earliest();
  void take_warnings(const BagStore& store);
  Message unpacked_if_packed(const StoredMessage& stored, const File& file);

  TopicTable table_;
  std::vector<File> files_;
  File* returned_ = nullptr;  ///< whose message was returned last; it must live until the next call
  Buffer buffer_;
  Problems warnings_;
};

Problems BagReader::Source::open(const fs::path& path) {
  auto files = bag_files(path);
  if (!files) return files.problems();
  warnings_ = files->warnings;
  Problems unread;
  for (const fs::path& file : files->paths) {
    const Problems problems = survey_file(file);
    unread.insert(unread.end(), problems.begin(), problems.end());
  }
  if (files_.empty()) return unread;
  if (table_.topics().empty() && !warnings_.empty()) return warnings_;
  warnings_.insert(warnings_.end(), unread.begin(), unread.end());
  order_files(files->in_recorded_order);
  return {};
}

Problems BagReader::Source::survey_file(const fs::path& path) {
  auto store = open_store(path, table_);
  if (!store) return store.problems();
  const auto survey = (*store)->survey();
  if (!survey) return survey.problems();
  take_warnings(**store);
  files_.push_back({.path = path, .survey = *survey});
  if (files_.size() == 1) files_.front().store = std::move(*store);  // need not be unpacked again
  return {};
}

void BagReader::Source::order_files(bool in_recorded_order) {
  const auto begins_earlier = [](const File& a, const File& b) {
    return a.survey.first && b.survey.first && *a.survey.first < *b.survey.first;
  };
  // By name alone, bags that were recorded side by side are in any order.
  if (!in_recorded_order) std::stable_sort(files_.begin(), files_.end(), begins_earlier);
  long number = 0;
  for (File& file : files_) {
    file.first_number = number;
    number += file.survey.messages;
  }
}

void BagReader::Source::want(const std::vector<std::size_t>& topics) {
  table_.want(topics);
  returned_ = nullptr;
  for (File& file : files_) {
    file.has_begun = false;
    file.head.reset();
    if (file.store) file.store->rewind();
  }
}

Result<std::optional<BagReader::Message>> BagReader::Source::next() {
  if (returned_ != nullptr) {
    if (Problems problems = advance(*std::exchange(returned_, nullptr)); !problems.empty()) return problems;
  }
  if (Problems problems = open_due_files(); !problems.empty()) return problems;
  returned_ = earliest();
  if (returned_ == nullptr) return std::optional<Message>();
  return std::optional(unpacked_if_packed(*returned_->head, *returned_));
}

Problems BagReader::Source::open_due_files() {
  for (File& file : files_) {
    if (file.has_begun) continue;
    const File* const first = earliest();
    // Files follow each other: one that begins before the one ahead of it had its clock set back.
    const bool is_set_back = &file != &files_.front() && file.survey.first < (&file - 1)->survey.first;
    if (first != nullptr && (is_set_back || file.survey.first > first->head->log_stamp)) return {};
    file.has_begun = true;
    if (!file.store) {
      auto store = open_store(file.path, table_);
      if (!store) return store.problems();
      file.store = std::move(*store);
    }
    if (Problems problems = advance(file); !problems.empty()) return problems;
  }
  return {};
}

Problems BagReader::Source::advance(File& file) {
  auto message = file.store->next();
  if (!message) return message.problems();
  file.head = *message;
  if (file.head) return {};
  take_warnings(*file.store);
  if (files_.size() > 1) file.store.reset();
  return {};
}

BagReader::Source::File* BagReader::Source::earliest() {
  File* first = nullptr;
  for (File& file : files_) {
    if (file.head && (first == nullptr || file.head->log_stamp < first->head->log_stamp)) first = &file;
  }
  return first;
}

void BagReader::Source::take_warnings(const BagStore& store) {
  for (const Problem& warning : store.warnings()) {
    const auto is_same = [&](const Problem& known) {
      return known.what == warning.what && known.where.file == warning.where.file;
    };
    if (std::none_of(warnings_.begin(), warnings_.end(), is_same)) warnings_.push_back(warning);
  }
}

BagReader::Message BagReader::Source::unpacked_if_packed(const StoredMessage& stored, const File& file) {
  Message message{stored.topic, stored.log_stamp, file.first_number + stored.number, stored.bytes};
  // CDR begins with a zero byte, so a message that was packed by itself cannot be mistaken.
  if (is_zstd(message.bytes) && topics()[message.topic].encoding == BagEncoding::kCdr)
    message.bytes = unpacked_message(message.bytes, buffer_);
  return message;
}

bool is_bag(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    if (fs::exists(path / kMetadataName, error)) return true;
    fs::directory_iterator entry(path, error), end;
    return !error && std::any_of(entry, end, [](const auto& file) { return has_bag_name(file.path()); });
  }
  return fs::is_regular_file(path, error) && (has_bag_name(path) || is_store(path));
}

BagReader::BagReader(std::unique_ptr<Source> source) : source_(std::move(source)) {}
BagReader::BagReader(BagReader&&) noexcept = default;
BagReader& BagReader::operator=(BagReader&&) noexcept = default;
BagReader::~BagReader() = default;

Result<BagReader> BagReader::open(const fs::path& path) {
  auto source = std::make_unique<Source>();
  if (Problems problems = source->open(path); !problems.empty()) return problems;
  return BagReader(std::move(source));
}

const std::vector<BagTopic>& BagReader::topics() const {
  return source_->topics();
}

void BagReader::want(const std::vector<std::size_t>& topics) {
  source_->want(topics);
}

Result<std::optional<BagReader::Message>> BagReader::next() {
  return source_->next();
}

const Problems& BagReader::warnings() const {
  return source_->warnings();
}

}  // namespace aisle
