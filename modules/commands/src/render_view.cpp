#include "aisle/commands/render_view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "aisle/commands/parameter_listing.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

constexpr int kJpegQuality = 90;

VehicleModel vehicle_with_ordinary_camera() {
  VehicleModel model;
  CameraDescription camera;
  camera.intrinsics.cx_px = (camera.width_px - 1) / 2.0;
  camera.intrinsics.cy_px = (camera.height_px - 1) / 2.0;
  camera.mount = {.p_vehicle_camera = {0, 0, 1.0}, .tilt_rad = 10 * kDegree};
  model.description.cameras = {camera};
  return model;
}

Result<VehicleModel> vehicle_of(const RenderViewOptions& options) {
  if (options.vehicle.empty()) return vehicle_with_ordinary_camera();
  return read_shipped_or_own("vehicles", options.vehicle.string(), read_vehicle);
}

Result<CameraDescription> camera_of(const VehicleDescription& vehicle, const RenderViewOptions& options) {
  std::string names;
  for (const CameraDescription& camera : vehicle.cameras) {
    if (options.camera.empty() || camera.name == options.camera) return camera;
    names += (names.empty() ? "" : ", ") + camera.name;
  }
  if (names.empty()) return Problem{{options.vehicle.string(), 0, "cameras"}, "the vehicle has no camera"};
  return Problem{{"--camera"}, fmt::format("there is no camera '{}'; there are: {}", options.camera, names)};
}

Result<Pose2> place_of(const World& world, const RenderViewOptions& options) {
  if (options.T_world_vehicle) return *options.T_world_vehicle;
  if (world.start) return *world.start;
  if (world.tour.size() >= 2) {
    const Vec2 ahead = world.tour[1] - world.tour[0];
    return Pose2{world.tour[0].x(), world.tour[0].y(), std::atan2(ahead.y(), ahead.x())};
  }
  return Problem{{options.world.string()}, "has neither a start nor a tour; --at says where the vehicle is"};
}

bool is_jpeg(const fs::path& path) {
  return path.extension() == ".jpg" || path.extension() == ".jpeg";
}

Problems unfit_for_output(const fs::path& path, bool force) {
  if (path.extension() != ".png" && !is_jpeg(path)) {
    return {{{path.string()}, "is not an image name: it must end in .png or .jpg"}};
  }
  std::error_code error;
  if (fs::is_directory(path, error)) return {{{path.string()}, "is a directory"}};
  if (!force && fs::exists(path, error)) return {{{path.string()}, "exists already; --force replaces it"}};
  return {};
}

double mean_grey(const Image& image) {
  return std::accumulate(image.bytes.begin(), image.bytes.end(), 0.0) /
         static_cast<double>(image.bytes.size());
}

}  // namespace

Outcome render_view_parameters() {
  CameraSensorParams params;
  return parameter_listing("sim render", fields_of(params));
}

Result<Outcome> run_render_view(const RenderViewOptions& options, Console&) {
  const auto world = read_shipped_or_own("worlds", options.world.string(), read_world);
  if (!world) return world.problems();
  const auto model = vehicle_of(options);
  if (!model) return model.problems();
  const auto camera = camera_of(model->description, options);
  if (!camera) return camera.problems();
  const auto place = place_of(*world, options);
  if (!place) return place.problems();
  const auto known = model->simulated.cameras.find(camera->name);
  CameraSensorParams params = known == model->simulated.cameras.end() ? CameraSensorParams{} : known->second;
  FieldList fields = fields_of(params);
  if (const Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (const Problems problems = unfit_for_output(options.out, options.force); !problems.empty())
    return problems;

  CameraMoment moment;
  moment.T_world_vehicle = *place;
  moment.lamps_on = !options.lamps_off;
  moment.light = options.light;
  moment.laser_on = options.laser;
  if (model->description.laser_markers) moment.laser_height_m = model->description.laser_markers->height_m;
  const Image image = CameraSensor(*camera, params, options.seed).take(RenderedWorld(*world), moment);
  const std::string bytes = is_jpeg(options.out) ? jpeg_bytes(image, kJpegQuality) : png_bytes(image);
  if (const Problems problems = write_whole_file(options.out, bytes); !problems.empty()) return problems;

  Outcome outcome{.verb = "sim render"};
  outcome.files = {{"picture", options.out.string()}};
  outcome.figures = {{"simulated", true},
                     {"seed", options.seed},
                     {"camera", camera->name},
                     {"width_px", image.width_px},
                     {"height_px", image.height_px},
                     {"x_m", place->x},
                     {"y_m", place->y},
                     {"heading_deg", std::round(to_degrees(place->theta) * 1000) / 1000},
                     {"mean_grey", std::round(mean_grey(image) * 10) / 10}};
  outcome.text = fmt::format("simulated image of camera {} in {}, {} x {} pixels: {}\n", camera->name,
                             world->name, image.width_px, image.height_px, options.out.string());
  return outcome;
}

}  // namespace aisle
