#pragma once

#include <vector>

#include "aisle/vehicle/camera_description.hpp"
#include "rendering/packet.hpp"

namespace aisle {

/// A box of slopes (x, y): the rays (x, y, 1) of the camera that lie in it. Negative half sizes: none.
struct SlopeBox {
  float x = 0, y = 0;  ///< its middle
  float half_x = -1, half_y = -1;

  bool is_empty() const { return half_x < 0; }
};

/// A square of 2^level x 2^level blocks of an image; a block is a packet of pixels.
struct Square {
  int level = 0;
  int column = 0, row = 0;  ///< among the squares of its level
};

/// Where each pixel of a camera looks, computed once. Slopes (x, y) stand for the ray (x, y, 1).
struct LensTable {
  /// A packet of pixels; those beyond the image's border look as the last ones before it.
  struct Block {
    Floats x, y;          ///< slopes of the pixels' middles
    Floats transmission;  ///< share of the light that the lens lets through; 0: no ray at all
    float x_by_u = 0, x_by_v = 0, y_by_u = 0, y_by_v = 0;  ///< from a pixel to the next ones
  };

  int width_px = 0, height_px = 0;
  int blocks_wide = 0, blocks_high = 0;
  std::vector<Block> blocks;  ///< row by row

  LensTable(const CameraDescription& camera, double vignetting);

  std::size_t block(int column, int row) const {
    return static_cast<std::size_t>(row * blocks_wide + column);
  }

  /// The one square that holds the whole image.
  Square whole() const { return {static_cast<int>(levels_.size()) - 1, 0, 0}; }
  /// What all pixels of a square see, from edge to edge.
  const SlopeBox& beam(const Square& square) const {
    const Level& level = levels_[static_cast<std::size_t>(square.level)];
    return level.beams[static_cast<std::size_t>(square.row * level.wide + square.column)];
  }
  bool holds(const Square& square) const {
    const Level& level = levels_[static_cast<std::size_t>(square.level)];
    return square.column < level.wide && square.row < level.high;
  }

 private:
  struct Level {
    int wide = 0, high = 0;
    std::vector<SlopeBox> beams;
  };

  void fill_block(const CameraModel& model, double vignetting, int column, int row);
  Level twice_as_wide(const Level& finer) const;

  std::vector<Level> levels_;  ///< of single blocks first
};

}  // namespace aisle
