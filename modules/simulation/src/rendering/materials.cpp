#include "rendering/materials.hpp"

#include "rendering/images.hpp"

namespace aisle {
namespace {

enum : int { kClouds, kGrain, kFibres, kSharedTextures };

constexpr int kDifferentPosters = 12;
constexpr int kDifferentBoards = 6;

/// A layer of a shared texture that repeats at these lengths along u and v.
PatternLayer layer(int texture, double repeat_u_m, double repeat_v_m, double contrast) {
  return {texture, static_cast<float>(Texture::kSide / repeat_u_m),
          static_cast<float>(Texture::kSide / repeat_v_m), static_cast<float>(contrast)};
}

}  // namespace

Materials::Materials(std::uint64_t texture_seed) : seed_(texture_seed) {
  textures_.emplace_back(clouds(seed_, 4));
  textures_.emplace_back(grain(seed_ + 1));
  textures_.emplace_back(clouds(seed_ + 2, 16));
}

int Materials::add(const Material& material) {
  all_.push_back(material);
  return static_cast<int>(all_.size()) - 1;
}

int Materials::plaster(double brightness) {
  return add({.brightness = static_cast<float>(brightness),
              .detail = layer(kGrain, 0.8, 0.8, 0.04),
              .unevenness = layer(kClouds, 5, 5, 0.08)});
}

int Materials::wood(double brightness) {
  return add({.brightness = static_cast<float>(brightness),
              .detail = layer(kFibres, 0.7, 9, 0.35),
              .unevenness = layer(kClouds, 1.3, 11, 0.15)});
}

int Materials::paint(double brightness) {
  return add({.brightness = static_cast<float>(brightness), .unevenness = layer(kClouds, 3, 3, 0.06)});
}

int Materials::floor(const FloorCovering& covering) {
  Material material{.brightness = static_cast<float>(covering.brightness),
                    .gloss = static_cast<float>(covering.gloss)};
  switch (covering.kind) {
    case FloorCovering::Kind::kPlain:
      material.detail = layer(kGrain, 1.0, 1.0, 0.4 * covering.contrast);
      material.unevenness = layer(kClouds, 4.7, 4.7, covering.contrast);
      break;
    case FloorCovering::Kind::kTiles:
      material.detail = layer(kGrain, 0.7, 0.7, 0.6 * covering.contrast);
      material.unevenness = layer(kClouds, 4.7, 4.7, 0.8 * covering.contrast);
      material.joints = {.period_u = static_cast<float>(covering.tile_m),
                         .period_v = static_cast<float>(covering.tile_m),
                         .width = 0.005f,
                         .darkness = static_cast<float>(std::min(0.9, 4 * covering.contrast)),
                         .variation = static_cast<float>(0.5 * covering.contrast)};
      break;
    case FloorCovering::Kind::kCarpet:
      material.detail = layer(kGrain, 0.9, 0.9, std::min(1.0, 2 * covering.contrast));
      material.unevenness = layer(kClouds, 4.7, 4.7, covering.contrast);
      material.joints = {.period_u = static_cast<float>(covering.tile_m),
                         .period_v = static_cast<float>(covering.tile_m),
                         .variation = static_cast<float>(covering.contrast)};
      break;
  }
  return add(material);
}

int Materials::ceiling(double brightness) {
  constexpr float kPanel_m = 0.625f;
  return add({.brightness = static_cast<float>(brightness),
              .detail = layer(kGrain, 1.1, 1.1, 0.05),
              .unevenness = layer(kClouds, 6, 6, 0.05),
              .joints = {kPanel_m, kPanel_m, 0.012f, 0.35f, 0.02f}});
}

int Materials::print(std::vector<int>& prints, Texture::Image (*draw)(std::uint64_t), int different) {
  const std::size_t hung = &prints == &posters_ ? posters_hung_++ : boards_hung_++;
  if (static_cast<int>(prints.size()) < different) {
    const auto texture = static_cast<int>(textures_.size());
    textures_.emplace_back(draw(seed_ + 1000 * static_cast<std::uint64_t>(texture)));
    prints.push_back(add({.brightness = 0.5f, .detail = {texture, Texture::kSide, Texture::kSide, 1.0f}}));
  }
  return prints[hung % prints.size()];
}

int Materials::poster() {
  return print(posters_, poster_print, kDifferentPosters);
}

int Materials::notice_board() {
  return print(boards_, pinned_sheets, kDifferentBoards);
}

int Materials::lamp(double power) {
  return add({.brightness = 0.8f, .glow = static_cast<float>(1.5 * std::min(1.0, power))});
}

int Materials::chessboard(const CalibrationBoard& board) {
  return add({.brightness = 0.95f,
              .chessboard_columns = static_cast<float>(board.columns + 3),
              .chessboard_rows = static_cast<float>(board.rows + 3)});
}

}  // namespace aisle
