#pragma once
/// Which panel a camera sees where. From one point everything flat is linear: in the slopes (x, y) of a ray
/// (x, y, 1), both the edges of a panel and how near it is (1 / depth) are a x + b y + c. So a whole beam of
/// rays is checked against a panel at once, and only beams that see several are divided down to single rays.

#include <optional>
#include <span>

#include "rendering/lens_table.hpp"
#include "rendering/viewpoints.hpp"

namespace aisle {

/// A panel as one viewpoint sees it.
struct SeenPanel {
  std::array<float, 4> edge_a{}, edge_b{}, edge_c{};  ///< all four >= 0: inside
  float near_a = 0, near_b = 0, near_c = 0;           ///< nearness of its plane [1/m]
  float nearest = 0;                                  ///< greatest nearness of what is ahead of the camera
  SlopeBox bounds;
  std::uint32_t number = 0;
};

/// @param corners  in turn around it, in the scene's frame; convex
/// @return nothing if the panel is behind the viewpoint or seen from its edge
std::optional<SeenPanel> seen_panel(const Corners& corners, const Viewpoint& view, std::uint32_t number);

/// A panel that some ray of a beam may see.
struct Candidate {
  const SeenPanel* panel = nullptr;
  float nearest = 0;    ///< greatest nearness within the beam
  bool covers = false;  ///< all rays of the beam meet it
};

/// Appends those of the candidates from `begin` to `end` that the beam may see: panels behind one that all
/// its rays meet are out.
void narrow(std::vector<Candidate>& candidates, std::size_t begin, std::size_t end, const SlopeBox& beam);

/// Which candidate each of sixteen rays sees: its place in the span, or kNoSurface. Of candidates in one
/// place it is the last one: what is printed on something comes after it.
void find_seen(std::span<const Candidate> candidates, const Floats& x, const Floats& y, Hits& seen);

/// A place within a pixel, from its middle [px].
struct PixelOffset {
  float u = 0, v = 0;
};

/// What samples of the pixels of a block see of one candidate.
struct Coverage {
  Flags any;     ///< a sample of the pixel sees it
  Floats share;  ///< of the pixel's samples
  Floats u, v;   ///< middle of those samples, from the pixel's middle [px]
};

/// @param seen  what each sample sees, as given by `find_seen`
/// @return whether any sample of any pixel sees the candidate
bool find_coverage(std::uint32_t candidate, std::span<const Hits> seen, std::span<const PixelOffset> samples,
                   Coverage& coverage);

}  // namespace aisle
