#include <fmt/format.h>

#include <fstream>
#include <utility>

#include "aisle/formats/bags/bag_reader.hpp"
#include "mcap_records.hpp"
#include "sessions/session_source.hpp"

namespace aisle {
namespace {

bool begins_with_magic(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(kMcapMagic.size(), '\0');
  return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == kMcapMagic;
}

/// Whether a recording was ended; one that was killed or is still going on has no end.
bool ends_with_magic(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string end(kMcapMagic.size(), '\0');
  file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  return file.read(end.data(), static_cast<std::streamsize>(end.size())) && end == kMcapMagic;
}

/// One walk over the messages of a bag.
class McapWalk {
 public:
  explicit McapWalk(BagReader bag) : bag_(std::move(bag)) {}

  /// A message that is before the one ahead of it is a problem.
  Result<std::optional<BagReader::Message>> next(const std::filesystem::path& path) {
    auto message = bag_.next();
    if (!message || !*message) return message;
    const ros::Stamp_ns stamp = (*message)->log_stamp;
    if (stamp < stamp_)
      return Problem{{path.string(), (*message)->number},
                     "this message is older than the one before: a session is in the order of its stamps"};
    stamp_ = stamp;
    return message;
  }

  BagReader& bag() { return bag_; }

 private:
  BagReader bag_;
  ros::Stamp_ns stamp_ = 0;
};

class McapSession final : public SessionSource {
 public:
  McapSession(const std::filesystem::path& path, BagReader bag)
      : SessionSource(path), messages_(std::move(bag)) {
    for (const BagTopic& topic : messages_.bag().topics())
      topics_.push_back({topic.name, topic.type, topic.latched});
  }

  Problems begin();
  const std::vector<SessionTopic>& topics() const override { return topics_; }
  Result<std::optional<SessionReader::Message>> next() override;
  Result<std::optional<std::string>> first_of(const std::string& topic) const override;
  Result<std::optional<Row>> next_row() override;

 private:
  /// The walk's next message, if the session has it.
  Result<std::optional<BagReader::Message>> step(McapWalk& walk);

  McapWalk messages_;
  std::optional<McapWalk> rows_;
  std::vector<SessionTopic> topics_;
  std::optional<ros::Stamp_ns> cut_;  ///< of the last message of a recording that was killed
};

/// A recording that was killed may end within a cycle; so its last stamp is left out.
Problems McapSession::begin() {
  for (const BagTopic& topic : messages_.bag().topics()) {
    if (topic.encoding != BagEncoding::kCdr)
      return {{{path().string(), 0, topic.name}, "is serialised as ROS 1 does; only cdr is read"}};
  }
  if (ends_with_magic(path())) return {};
  auto walk = BagReader::open(path());
  if (!walk) return walk.problems();
  while (true) {
    const auto message = walk->next();
    if (!message) return message.problems();
    if (!*message) return {};
    cut_ = (*message)->log_stamp;
  }
}

Result<std::optional<BagReader::Message>> McapSession::step(McapWalk& walk) {
  while (true) {
    auto message = walk.next(path());
    if (!message) return message;
    if (!*message) break;
    if ((*message)->log_stamp == cut_) return std::optional<BagReader::Message>();
    if ((*message)->topic < topics_.size()) return message;  // else the summary does not tell of it
  }
  const Problems& damage = walk.bag().warnings();
  if (!cut_ && !damage.empty()) return damage;
  return std::optional<BagReader::Message>();
}

Result<std::optional<SessionReader::Message>> McapSession::next() {
  const auto message = step(messages_);
  if (!message) return message.problems();
  if (!*message) return std::optional<SessionReader::Message>();
  return std::optional(
      SessionReader::Message{topics_[(*message)->topic], (*message)->log_stamp, (*message)->bytes});
}

Result<std::optional<SessionSource::Row>> McapSession::next_row() {
  if (!rows_) {
    auto bag = BagReader::open(path());
    if (!bag) return bag.problems();
    rows_.emplace(std::move(*bag));
  }
  const auto message = step(*rows_);
  if (!message) return message.problems();
  if (!*message) return std::optional<Row>();
  const auto bytes = static_cast<std::int64_t>((*message)->bytes.size());
  return std::optional(Row{(*message)->topic, (*message)->log_stamp, bytes});
}

Result<std::optional<std::string>> McapSession::first_of(const std::string& topic) const {
  auto bag = BagReader::open(path());
  if (!bag) return bag.problems();
  for (std::size_t i = 0; i < bag->topics().size(); ++i) {
    if (bag->topics()[i].name != topic) continue;
    bag->want({i});
    const auto message = bag->next();
    if (!message) return message.problems();
    if (*message) return std::optional(std::string((*message)->bytes));
  }
  return std::optional<std::string>();
}

/// A recording that was killed before its first second was written: a head, and nothing behind it.
class EmptyMcapSession final : public SessionSource {
 public:
  explicit EmptyMcapSession(const std::filesystem::path& path) : SessionSource(path) {}

  const std::vector<SessionTopic>& topics() const override { return no_topics_; }
  Result<std::optional<SessionReader::Message>> next() override {
    return std::optional<SessionReader::Message>();
  }
  Result<std::optional<std::string>> first_of(const std::string&) const override {
    return std::optional<std::string>();
  }
  Result<std::optional<Row>> next_row() override { return std::optional<Row>(); }

 private:
  std::vector<SessionTopic> no_topics_;
};

}  // namespace

Result<std::unique_ptr<SessionSource>> open_mcap_session(const std::filesystem::path& path) {
  auto bag = BagReader::open(path);
  if (!bag && begins_with_magic(path) && !ends_with_magic(path))
    return std::unique_ptr<SessionSource>(std::make_unique<EmptyMcapSession>(path));
  if (!bag) return bag.problems();
  auto session = std::make_unique<McapSession>(path, std::move(*bag));
  if (Problems problems = session->begin(); !problems.empty()) return problems;
  return std::unique_ptr<SessionSource>(std::move(session));
}

}  // namespace aisle
