#include "bags/bag_store.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bags/bag_files.hpp"
#include "bags/mcap_store.hpp"
#include "bags/ros1_store.hpp"
#include "bags/sqlite_store.hpp"
#include "bags/unpacking.hpp"
#include "mcap_records.hpp"
#include "unpacking_directory.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kWarningsMax = 20;

/// A store whose file was packed as a whole: the store of the unpacked file.
class PackedStore : public BagStore {
 public:
  PackedStore(const fs::path& path, TopicTable& topics, UnpackingDirectory directory,
              std::unique_ptr<BagStore> store)
      : BagStore(path, topics), directory_(std::move(directory)), store_(std::move(store)) {}

  Result<Survey> survey() override { return store_->survey(); }
  Result<std::optional<StoredMessage>> next() override { return store_->next(); }
  void rewind() override { store_->rewind(); }
  Problems warnings() const override {
    Problems warnings = store_->warnings();
    for (Problem& warning : warnings) warning.where.file = shown_path().string();
    return warnings;
  }

 private:
  UnpackingDirectory directory_;
  std::unique_ptr<BagStore> store_;
};

Result<std::unique_ptr<BagStore>> open_packed(const fs::path& path, TopicTable& topics) {
  auto directory = UnpackingDirectory::create();
  if (!directory) return directory.problems();
  const fs::path file = directory->path() / path.stem();
  const auto whole = unpack_file(path, file);  // a cut is seen when the unpacked file ends too early
  if (!whole) return whole.problems();
  auto store = open_store(file, topics);
  if (!store) return Problem{{path.string()}, store.problems().front().what};
  return std::unique_ptr<BagStore>(
      std::make_unique<PackedStore>(path, topics, std::move(*directory), std::move(*store)));
}

}  // namespace

void BagStore::warn(std::string what) {
  const auto is_same = [&](const Problem& warning) { return warning.what == what; };
  if (std::any_of(warnings_.begin(), warnings_.end(), is_same) || warnings_.size() == kWarningsMax) return;
  warnings_.push_back({{path_.string()}, std::move(what)});
}

std::size_t TopicTable::index_of(const BagTopic& topic) {
  const auto is_it = [&](const BagTopic& known) {
    return known.name == topic.name && known.type == topic.type && known.encoding == topic.encoding;
  };
  const auto found = std::find_if(topics_.begin(), topics_.end(), is_it);
  const auto index = static_cast<std::size_t>(found - topics_.begin());
  if (found == topics_.end()) {
    topics_.push_back(topic);
    wanted_.push_back(new_are_wanted_);
  }
  topics_[index].latched |= topic.latched;
  return index;
}

void TopicTable::want(const std::vector<std::size_t>& topics) {
  wanted_.assign(topics_.size(), false);
  for (const std::size_t topic : topics) wanted_.at(topic) = true;
  new_are_wanted_ = false;
}

std::string with_msg(const std::string& type) {
  const std::size_t slash = type.find('/');
  if (slash == std::string::npos || type.find('/', slash + 1) != std::string::npos) return type;
  return type.substr(0, slash) + "/msg" + type.substr(slash);
}

std::optional<BagEncoding> encoding_of(std::string_view name) {
  if (name == "cdr") return BagEncoding::kCdr;
  if (name == "ros1") return BagEncoding::kRos1;
  return std::nullopt;
}

bool is_store(const fs::path& path) {
  auto file = ByteStream::open(path);
  if (!file) return false;
  const std::string_view start = file->peek(SqliteStore::kMagic.size());
  return start == SqliteStore::kMagic || start.starts_with(kMcapMagic) || start.starts_with("#ROSBAG V");
}

Result<std::unique_ptr<BagStore>> open_store(const fs::path& path, TopicTable& topics) {
  auto file = ByteStream::open(path);
  if (!file) return file.problems();
  const std::string start(file->peek(SqliteStore::kMagic.size()));
  if (start == SqliteStore::kMagic) return SqliteStore::open(path, topics);
  if (start.starts_with(kMcapMagic))
    return std::unique_ptr<BagStore>(std::make_unique<McapStore>(path, topics, std::move(*file)));
  if (start.starts_with(Ros1Store::kMagic))
    return std::unique_ptr<BagStore>(std::make_unique<Ros1Store>(path, topics, std::move(*file)));
  if (is_zstd(start) && path.extension() == ".zstd") return open_packed(path, topics);
  if (start.starts_with("#ROSBAG V"))
    return Problem{{path.string()}, "is a bag of an older version; `rosbag fix` makes one of version 2.0"};
  return Problem{{path.string()}, "is not a bag: it begins neither as SQLite, MCAP nor ROS 1 bags do"};
}

}  // namespace aisle
