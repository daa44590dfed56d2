#include "rendering/scene.hpp"

namespace aisle {

RenderedWorld::RenderedWorld(const World& world) : scene_(std::make_unique<Scene>(world)) {}
RenderedWorld::~RenderedWorld() = default;
RenderedWorld::RenderedWorld(RenderedWorld&&) noexcept = default;
RenderedWorld& RenderedWorld::operator=(RenderedWorld&&) noexcept = default;

void RenderedWorld::place(std::span<const MovingBody> bodies) {
  scene_->place(bodies);
}

}  // namespace aisle
