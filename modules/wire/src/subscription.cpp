#include "subscription.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <set>

#include "quality_of_service.hpp"
#include "ros_names.hpp"

namespace aisle {
namespace {

namespace fdds = eprosima::fastdds::dds;

/// Hands each message to the sink, until it is closed.
class SinkListener final : public fdds::DataReaderListener {
 public:
  explicit SinkListener(Wire::Sink sink) : sink_(std::move(sink)) {}

  /// Returns once the sink is no longer called.
  void close() {
    const std::lock_guard lock(sink_mutex_);
    sink_ = nullptr;
  }

  // Only the call of the sink is locked: Fast DDS has locks of its own here, and close() must not wait for
  // them.
  void on_data_available(fdds::DataReader* reader) override {
    std::string message;
    fdds::SampleInfo info;
    while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
      const std::lock_guard lock(sink_mutex_);
      if (info.valid_data && sink_) sink_(message);
    }
  }

 private:
  std::mutex sink_mutex_;
  Wire::Sink sink_;
};

class FastDdsSubscription final : public WireSubscription {
 public:
  FastDdsSubscription(std::shared_ptr<Participant> participant, TopicUse topic, WireQuality quality,
                      Wire::Sink sink)
      : participant_(std::move(participant)),
        topic_(std::move(topic)),
        quality_(quality),
        listener_(std::move(sink)),
        reader_(participant_->subscriber().create_datareader(topic_.get(), reader_qos(quality), &listener_,
                                                             fdds::StatusMask::data_available())) {}
  FastDdsSubscription(const FastDdsSubscription&) = delete;
  FastDdsSubscription& operator=(const FastDdsSubscription&) = delete;

  ~FastDdsSubscription() override {
    listener_.close();
    if (is_open()) participant_->subscriber().delete_datareader(reader_);
  }

  bool is_open() const { return reader_ != nullptr; }

  std::size_t publishers() const override {
    fdds::SubscriptionMatchedStatus status;
    reader_->get_subscription_matched_status(status);
    return static_cast<std::size_t>(status.current_count);
  }

  std::string incompatible_quality() const override {
    std::set<std::string> incompatible;
    for (const WireEndpoint& endpoint : participant_->endpoints())
      if (is_publisher_of_this(endpoint)) incompatible.merge(missing_quality(quality_, endpoint));
    return fmt::format("{}", fmt::join(incompatible, ", "));
  }

 private:
  bool is_publisher_of_this(const WireEndpoint& endpoint) const {
    return endpoint.kind == WireEndpoint::Kind::kPublisher &&
           endpoint.topic == ros_topic(topic_->get_name()) &&
           endpoint.type == ros_type(topic_->get_type_name());
  }

  std::shared_ptr<Participant> participant_;
  TopicUse topic_;
  WireQuality quality_;
  SinkListener listener_;
  fdds::DataReader* reader_;
};

}  // namespace

Result<std::unique_ptr<WireSubscription>> open_subscription(std::shared_ptr<Participant> participant,
                                                            const std::string& topic, const std::string& type,
                                                            WireQuality quality, Wire::Sink sink) {
  auto used = participant->use_topic(topic, type);
  if (!used) return used.problems();
  auto opened = std::make_unique<FastDdsSubscription>(std::move(participant), std::move(*used), quality,
                                                      std::move(sink));
  if (!opened->is_open()) return Problem{{.key = topic}, "cannot be subscribed to"};
  return std::unique_ptr<WireSubscription>(std::move(opened));
}

}  // namespace aisle
