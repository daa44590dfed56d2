#include "rendering/scene_plan.hpp"

namespace aisle {
namespace {

constexpr int kLimbSides = 10;

/// A round part of a person, its measures as shares of the person's depth, width and height.
struct Limb {
  double x, y, depth, width, bottom, top, brightness;
};

/// Legs, trunk, arms, neck and head; trousers darker than the shirt, skin brighter.
constexpr Limb kPerson[] = {
    {0.10, 0.20, 0.50, 0.30, 0.00, 0.48, 0.6},  {-0.10, -0.20, 0.50, 0.30, 0.00, 0.48, 0.6},
    {0.00, 0.00, 0.75, 0.70, 0.46, 0.82, 1.0},  {0.00, 0.43, 0.35, 0.15, 0.42, 0.81, 0.9},
    {0.00, -0.43, 0.35, 0.15, 0.42, 0.81, 0.9}, {0.00, 0.00, 0.35, 0.22, 0.82, 0.87, 1.4},
    {0.05, 0.00, 0.60, 0.30, 0.865, 1.00, 1.4},
};

}  // namespace

void add_body(const MovingBody& body, Materials& materials, Panels& panels) {
  if (body.kind == MovingBody::Kind::kBox) {
    add_prism(box(body.T_world_body, body.size, 0, body.height_m), materials.paint(body.brightness), panels);
    return;
  }
  for (const Limb& limb : kPerson) {
    const Pose2 T_body_limb{limb.x * body.size.x(), limb.y * body.size.y(), 0};
    add_prism(
        pillar(body.T_world_body * T_body_limb, {limb.depth * body.size.x(), limb.width * body.size.y()},
               limb.bottom * body.height_m, limb.top * body.height_m, kLimbSides),
        materials.paint(std::min(1.0, limb.brightness * body.brightness)), panels);
  }
}

}  // namespace aisle
