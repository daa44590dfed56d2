#include "publisher.hpp"

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>

#include "quality_of_service.hpp"

namespace aisle {
namespace {

namespace fdds = eprosima::fastdds::dds;

class FastDdsPublisher final : public WirePublisher {
 public:
  FastDdsPublisher(std::shared_ptr<Participant> participant, TopicUse topic, WireQuality quality)
      : participant_(std::move(participant)),
        topic_(std::move(topic)),
        writer_(participant_->publisher().create_datawriter(topic_.get(), writer_qos(quality))) {}
  FastDdsPublisher(const FastDdsPublisher&) = delete;
  FastDdsPublisher& operator=(const FastDdsPublisher&) = delete;

  ~FastDdsPublisher() override {
    if (is_open()) participant_->publisher().delete_datawriter(writer_);
  }

  bool is_open() const { return writer_ != nullptr; }

  void publish(std::string_view message) override { writer_->write(&message); }

  std::size_t subscribers() const override {
    fdds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return static_cast<std::size_t>(status.current_count);
  }

 private:
  std::shared_ptr<Participant> participant_;
  TopicUse topic_;
  fdds::DataWriter* writer_;
};

}  // namespace

Result<std::unique_ptr<WirePublisher>> open_publisher(std::shared_ptr<Participant> participant,
                                                      const std::string& topic, const std::string& type,
                                                      WireQuality quality) {
  auto used = participant->use_topic(topic, type);
  if (!used) return used.problems();
  auto opened = std::make_unique<FastDdsPublisher>(std::move(participant), std::move(*used), quality);
  if (!opened->is_open()) return Problem{{.key = topic}, "cannot be published on"};
  return std::unique_ptr<WirePublisher>(std::move(opened));
}

}  // namespace aisle
