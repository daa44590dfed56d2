#include "aisle/live/client_frame.hpp"
#include "aisle/live/drive_command.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

namespace {

bool is_within(std::string_view part, std::string_view whole) {
  return part.data() >= whole.data() && part.data() + part.size() <= whole.data() + whole.size();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view input = fuzz_text(bytes, size);
  (void)parse_client_text(input);
  if (const auto command = parse_drive_command(input)) require(command->age_s >= 0);
  const auto frame = parse_client_bytes(input);
  if (!frame) return 0;
  if (const auto* call = std::get_if<ServiceRequest>(&*frame))
    require(is_within(call->encoding, input) && is_within(call->data, input));
  if (const auto* playback = std::get_if<PlaybackRequest>(&*frame)) require(is_within(playback->id, input));
  if (const auto* message = std::get_if<ClientMessage>(&*frame)) require(is_within(message->data, input));
  return 0;
}
