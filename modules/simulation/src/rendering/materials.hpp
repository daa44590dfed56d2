#pragma once

#include <vector>

#include "aisle/simulation/world.hpp"
#include "rendering/surface.hpp"

namespace aisle {

/// The materials of a world, and the textures that they share.
class Materials {
 public:
  explicit Materials(std::uint64_t texture_seed);

  int plaster(double brightness);
  int wood(double brightness);
  int paint(double brightness);  ///< frames, skirting, lines, cloth
  int floor(const FloorCovering& covering);
  int ceiling(double brightness);
  int poster();
  int notice_board();
  int lamp(double power);
  int chessboard(const CalibrationBoard& board);

  const std::vector<Material>& all() const { return all_; }
  const std::vector<Texture>& textures() const { return textures_; }
  /// Forgets all materials after the first `count`.
  void keep(std::size_t count) { all_.resize(count); }

 private:
  int add(const Material& material);
  int print(std::vector<int>& prints, Texture::Image (*draw)(std::uint64_t), int different);

  std::uint64_t seed_;
  std::vector<Material> all_;
  std::vector<Texture> textures_;
  std::vector<int> posters_, boards_;
  std::size_t posters_hung_ = 0, boards_hung_ = 0;
};

}  // namespace aisle
