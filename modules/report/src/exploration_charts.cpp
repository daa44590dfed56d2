#include "aisle/report/exploration_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "canvas.hpp"
#include "palette.hpp"
#include "picture_scale.hpp"

namespace aisle {
namespace {

constexpr int kWidth_px = 1200;
constexpr double kLeft_px = 90, kRight_px = kWidth_px - 30, kTop_px = 46, kChartBottom_px = 72;
constexpr Color kCurve{0.13, 0.47, 0.86}, kUnderCurve{0.13, 0.47, 0.86, 0.15}, kRule{0.88, 0.89, 0.91};
constexpr std::array<Color, 6> kStateColors = {{{0.30, 0.62, 0.87},
                                                {0.95, 0.66, 0.24},
                                                {0.45, 0.74, 0.45},
                                                {0.80, 0.42, 0.60},
                                                {0.60, 0.55, 0.80},
                                                {0.60, 0.60, 0.60}}};
constexpr Font kAxisFont{15, kQuietInk};
constexpr Font kChartTitleFont{17, kInk, true};

/// Axes of values over the driven distance, laid out between the margins.
struct Axes {
  double distance_m = 1;
  double value_max = 1;
  double top_px = kTop_px;
  double bottom_px = 400;

  Vec2 at(double along_m, double value) const {
    return {kLeft_px + (kRight_px - kLeft_px) * along_m / distance_m,
            bottom_px - (bottom_px - top_px) * value / value_max};
  }
};

/// Lines at round values, with their labels.
void draw_axes(Canvas& canvas, const Axes& axes, const std::string& title, const std::string& unit) {
  const double value_step = round_length(std::max(axes.value_max / 3, 1e-9));
  for (int i = 0; i * value_step <= axes.value_max; ++i) {
    const Vec2 left = axes.at(0, i * value_step);
    canvas.line(left, axes.at(axes.distance_m, i * value_step), {kRule, 1});
    const std::string label = fmt::format("{:g}", i * value_step);
    canvas.text(left - Vec2(canvas.text_width(label, kAxisFont) + 10, -5), label, kAxisFont);
  }
  const double distance_step_m = round_length(std::max(axes.distance_m / 5, 1e-9));
  for (int i = 0; i * distance_step_m <= axes.distance_m; ++i) {
    const Vec2 tick = axes.at(i * distance_step_m, 0);
    canvas.line(tick, tick + Vec2(0, 6), {kQuietInk, 1});
    const std::string label = fmt::format("{:g}{}", i * distance_step_m, i == 0 ? " m of path" : "");
    const double shift_px = i == 0 ? 0 : canvas.text_width(label, kAxisFont) / 2;
    canvas.text(tick + Vec2(-shift_px, 24), label, kAxisFont);
  }
  canvas.line(axes.at(0, 0), axes.at(axes.distance_m, 0), {kQuietInk, 1.5});
  canvas.text({kLeft_px, axes.top_px - 16}, title + (unit.empty() ? "" : " [" + unit + "]"), kChartTitleFont);
}

void draw_area(Canvas& canvas, const Axes& axes, const std::vector<Vec2>& curve) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Vec2 &a = curve[i - 1], &b = curve[i];
    canvas.areas({{a, b, Vec2(b.x(), axes.bottom_px), Vec2(a.x(), axes.bottom_px)}}, kUnderCurve);
  }
  canvas.polyline(curve, {kCurve, 2.5});
}

/// The driven distance up to each cycle.
std::vector<double> distances_m_of(const std::vector<Pose2>& poses) {
  std::vector<double> distances_m(poses.size(), 0.0);
  for (std::size_t i = 1; i < poses.size(); ++i)
    distances_m[i] = distances_m[i - 1] + (poses[i].position() - poses[i - 1].position()).norm();
  return distances_m;
}

/// A state of the transducer over the distance that it lasted.
struct StateSpan {
  const TransducerStep* step = nullptr;
  double from_m = 0, to_m = 0;
};

std::vector<StateSpan> state_spans_of(const ExplorationRecord& record) {
  const std::vector<double> distances_m = distances_m_of(record.T_map_vehicle);
  const auto distance_at = [&](std::size_t cycle) {
    return distances_m.empty() ? 0 : distances_m[std::min(cycle, distances_m.size() - 1)];
  };
  std::vector<StateSpan> spans;
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const bool is_last = i + 1 == record.steps.size();
    const std::size_t end = is_last ? record.T_map_vehicle.size() : record.steps[i + 1].cycle;
    spans.push_back({&record.steps[i], distance_at(record.steps[i].cycle), distance_at(end)});
  }
  return spans;
}

std::vector<std::string> states_of(const ExplorationRecord& record) {
  std::vector<std::string> states;
  for (const TransducerStep& step : record.steps) {
    if (std::find(states.begin(), states.end(), step.state) == states.end()) states.push_back(step.state);
  }
  return states;
}

Color color_of(const std::vector<std::string>& states, const std::string& state) {
  const auto place = std::find(states.begin(), states.end(), state) - states.begin();
  return kStateColors[static_cast<std::size_t>(place) % kStateColors.size()];
}

/// A band of colours, one per state, with the states' names from left to right above it.
void draw_states(Canvas& canvas, const Axes& axes, const std::vector<StateSpan>& spans,
                 const std::vector<std::string>& states) {
  constexpr double kBandTop_px = 34, kBandBottom_px = 62;
  double label_px = kLeft_px;
  for (const std::string& state : states) {
    canvas.disc({label_px + 7, 19}, 7, color_of(states, state));
    canvas.text({label_px + 20, 24}, state, kAxisFont);
    label_px += 44 + canvas.text_width(state, kAxisFont);
  }
  for (const StateSpan& span : spans) {
    const double from_px = axes.at(span.from_m, 0).x(), to_px = axes.at(span.to_m, 0).x();
    canvas.areas({{Vec2(from_px, kBandTop_px), Vec2(to_px, kBandTop_px), Vec2(to_px, kBandBottom_px),
                   Vec2(from_px, kBandBottom_px)}},
                 color_of(states, span.step->state));
  }
}

}  // namespace

std::string coverage_svg(const ExplorationRecord& record) {
  constexpr int kHeight_px = 360;
  Axes axes{.bottom_px = kHeight_px - kChartBottom_px};
  for (const CoverageMark& mark : record.coverage) {
    axes.distance_m = std::max(axes.distance_m, mark.path_m);
    axes.value_max = std::max(axes.value_max, mark.free_m2);
  }
  std::vector<Vec2> curve;
  for (const CoverageMark& mark : record.coverage) curve.push_back(axes.at(mark.path_m, mark.free_m2));
  return svg_document(kWidth_px, kHeight_px, [&](Canvas& canvas) {
    canvas.fill(kPaper);
    draw_axes(canvas, axes, "known floor", "m2");
    draw_area(canvas, axes, curve);
  });
}

std::string transducer_svg(const ExplorationRecord& record) {
  constexpr int kHeight_px = 330;
  const std::vector<StateSpan> spans = state_spans_of(record);
  const std::vector<std::string> states = states_of(record);
  Axes axes{.top_px = 114, .bottom_px = kHeight_px - kChartBottom_px};
  std::vector<Vec2> curve;
  for (const StateSpan& span : spans) {
    axes.distance_m = std::max(axes.distance_m, span.to_m);
    axes.value_max = std::max(axes.value_max, static_cast<double>(span.step->stack));
  }
  for (const StateSpan& span : spans) {
    const auto stack = static_cast<double>(span.step->stack);
    curve.push_back(axes.at(span.from_m, stack));
    curve.push_back(axes.at(span.to_m, stack));
  }
  return svg_document(kWidth_px, kHeight_px, [&](Canvas& canvas) {
    canvas.fill(kPaper);
    draw_states(canvas, axes, spans, states);
    draw_axes(canvas, axes, "symbols on the stack", "");
    draw_area(canvas, axes, curve);
  });
}

}  // namespace aisle
