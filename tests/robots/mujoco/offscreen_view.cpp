#include "offscreen_view.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <stdexcept>

namespace robots {

/// An OpenGL context that belongs to no window.
class OffscreenView::Egl {
 public:
  Egl() {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    require(platform_display != nullptr, "platform displays");
    display_ = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    require(eglInitialize(display_, nullptr, nullptr) == EGL_TRUE, "surfaceless display");
    const EGLint wanted[] = {
        EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    require(eglChooseConfig(display_, wanted, &config, 1, &count) == EGL_TRUE && count == 1, "configuration");
    require(eglBindAPI(EGL_OPENGL_API) == EGL_TRUE, "OpenGL");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    require(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE, "context");
  }

  ~Egl() { eglTerminate(display_); }
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;

 private:
  static void require(bool there, const char* what) {
    if (!there) throw std::runtime_error(std::string("EGL has no ") + what);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

OffscreenView::OffscreenView(const Physics& physics) : egl_(std::make_unique<Egl>()) {
  constexpr int kSpare = 100;
  mjv_defaultScene(&scene_);
  mjv_makeScene(physics.model(), &scene_, physics.model()->ngeom + kSpare);
  scene_.flags[mjRND_SHADOW] = 0;
  scene_.flags[mjRND_REFLECTION] = 0;
  mjr_defaultContext(&context_);
  mjr_makeContext(physics.model(), &context_, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, &context_);
}

OffscreenView::~OffscreenView() {
  mjr_freeContext(&context_);
  mjv_freeScene(&scene_);
}

std::vector<std::uint8_t> OffscreenView::draw(const Physics& physics, const char* camera,
                                              const ImageSize& size) {
  mjvOption options;
  mjv_defaultOption(&options);
  options.flags[mjVIS_ACTUATOR] = 0;
  options.sitegroup[0] = 0;
  mjvCamera eye;
  mjv_defaultCamera(&eye);
  eye.type = mjCAMERA_FIXED;
  eye.fixedcamid = physics.id(mjOBJ_CAMERA, camera);
  mjv_updateScene(physics.model(), physics.data(), &options, nullptr, &eye, mjCAT_ALL, &scene_);
  const mjrRect area{0, 0, size.width_px, size.height_px};
  mjr_render(area, &scene_, &context_);

  const std::size_t row = 3 * static_cast<std::size_t>(size.width_px);
  std::vector<std::uint8_t> from_below(row * size.height_px), pixels;
  mjr_readPixels(from_below.data(), nullptr, area, &context_);
  pixels.reserve(from_below.size());
  for (int y = size.height_px - 1; y >= 0; --y) {
    const auto start = from_below.begin() + static_cast<std::ptrdiff_t>(row * y);
    pixels.insert(pixels.end(), start, start + static_cast<std::ptrdiff_t>(row));
  }
  return pixels;
}

}  // namespace robots
