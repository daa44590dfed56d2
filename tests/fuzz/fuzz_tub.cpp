/// The texts of tubs and lists of images. The first byte of the input says which.

#include <cmath>

#include "fuzz_input.hpp"
#include "image_sequences/donkey_tub.hpp"
#include "image_sequences/image_folder.hpp"
#include "image_sequences/stamp_order.hpp"

using namespace aisle;

namespace {

void read_catalog(std::string_view text) {
  LeftOut unreadable;
  for (const TubRecord& record : parse_tub_catalog(text, "input", "cam/image_array", unreadable)) {
    require(record.index >= 0 && record.stamp_s >= 0 && record.stamp_s <= kStampMax_s);
    require(record.image.find('/') == std::string::npos);
  }
}

void read_list(std::string_view text) {
  auto list = parse_image_csv(text, "input", {.rate_hz = {}, .front_steered = FrontSteered{}});
  if (!list.ok() || !order_stamps(*list).empty()) return;
  for (std::size_t i = 1; i < list->images.size(); ++i)
    require(list->images[i].stamp_s > list->images[i - 1].stamp_s);
  for (const ListedImage& image : list->images)
    require(image.T_odom_vehicle.has_value() == list->has_odometry);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text = fuzz_text(bytes, size);
  if (text.empty()) return 0;
  switch (text.front()) {
    case 'm':
      if (const auto manifest = parse_tub_manifest(text.substr(1), "input"); manifest.ok())
        require(!manifest->catalogs.empty() && !manifest->image_keys.empty());
      break;
    case 'c':
      read_catalog(text.substr(1));
      break;
    case 'o':
      (void)parse_old_tub_record(text.substr(1), 0, true);
      break;
    default:
      read_list(text.substr(1));
  }
  return 0;
}
