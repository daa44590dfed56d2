#include "aisle/wire/wire.hpp"
#include "participant.hpp"
#include "publisher.hpp"
#include "settings_check.hpp"
#include "subscription.hpp"

namespace aisle {
namespace {

class FastDdsWire final : public Wire {
 public:
  explicit FastDdsWire(std::shared_ptr<Participant> participant) : participant_(std::move(participant)) {}

  Result<std::unique_ptr<WireSubscription>> subscribe(const std::string& topic, const std::string& type,
                                                      WireQuality quality, Sink sink) override {
    return open_subscription(participant_, topic, type, quality, std::move(sink));
  }

  Result<std::unique_ptr<WirePublisher>> advertise(const std::string& topic, const std::string& type,
                                                   WireQuality quality) override {
    return open_publisher(participant_, topic, type, quality);
  }

  std::vector<WireEndpoint> endpoints() const override { return participant_->endpoints(); }

 private:
  std::shared_ptr<Participant> participant_;
};

}  // namespace

Result<std::unique_ptr<Wire>> Wire::open(const WireSettings& settings) {
  if (Problems problems = check_settings(settings, own_addresses()); !problems.empty()) return problems;
  auto participant = Participant::open(settings);
  if (!participant) return participant.problems();
  return std::unique_ptr<Wire>(std::make_unique<FastDdsWire>(std::move(*participant)));
}

}  // namespace aisle
