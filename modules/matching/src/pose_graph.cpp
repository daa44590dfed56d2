#include "aisle/matching/pose_graph.hpp"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <deque>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

using Node = std::array<double, 3>;

/// Whitened difference between the measured and the current relative pose.
class RelativePoseCost final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  /// @param T_from_to  as measured; must outlive this
  RelativePoseCost(const Pose2& T_from_to, const Mat3& information)
      : measured_(T_from_to), root_(information.llt().matrixU()) {}

  bool Evaluate(const double* const* nodes, double* residuals, double** jacobians) const override {
    const Pose2 from{nodes[0][0], nodes[0][1], nodes[0][2]};
    const double c = std::cos(from.theta), s = std::sin(from.theta);
    const double dx = nodes[1][0] - from.x, dy = nodes[1][1] - from.y;
    const Vec2 present(c * dx + s * dy, -s * dx + c * dy);
    const Vec3 difference(present.x() - measured_.x, present.y() - measured_.y,
                          wrap_angle(nodes[1][2] - from.theta - measured_.theta));
    Eigen::Map<Vec3> whitened(residuals);
    whitened = root_ * difference;
    using RowMat3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    if (jacobians && jacobians[0]) {
      Mat3 by_from;
      by_from << -c, -s, present.y(), s, -c, -present.x(), 0, 0, -1;
      Eigen::Map<RowMat3> whitened_by_from(jacobians[0]);
      whitened_by_from = root_ * by_from;
    }
    if (jacobians && jacobians[1]) {
      Mat3 by_to;
      by_to << c, s, 0, -s, c, 0, 0, 0, 1;
      Eigen::Map<RowMat3> whitened_by_to(jacobians[1]);
      whitened_by_to = root_ * by_to;
    }
    return true;
  }

 private:
  const Pose2& measured_;
  Mat3 root_;
};

class HeadingCost final : public ceres::SizedCostFunction<1, 3> {
 public:
  HeadingCost(double heading_rad, double sigma_rad) : heading_rad_(heading_rad), sigma_rad_(sigma_rad) {}

  bool Evaluate(const double* const* nodes, double* residuals, double** jacobians) const override {
    residuals[0] = wrap_angle(nodes[0][2] - heading_rad_) / sigma_rad_;
    if (jacobians && jacobians[0]) {
      jacobians[0][0] = jacobians[0][1] = 0;
      jacobians[0][2] = 1 / sigma_rad_;
    }
    return true;
  }

 private:
  double heading_rad_;
  double sigma_rad_;
};

}  // namespace

struct PoseGraph::Impl {
  std::deque<Node> nodes;  // deques: the problem holds their addresses
  std::deque<Pose2> odometry, loop_closures;
  ceres::Problem problem;

  void add(const PoseConstraint& constraint, std::deque<Pose2>& measured, ceres::LossFunction* loss) {
    measured.push_back(constraint.T_from_to);
    problem.AddResidualBlock(new RelativePoseCost(measured.back(), constraint.information), loss,
                             nodes.at(constraint.from).data(), nodes.at(constraint.to).data());
  }
};

PoseGraph::PoseGraph() : impl_(std::make_unique<Impl>()) {}
PoseGraph::~PoseGraph() = default;
PoseGraph::PoseGraph(PoseGraph&&) noexcept = default;
PoseGraph& PoseGraph::operator=(PoseGraph&&) noexcept = default;

std::size_t PoseGraph::add_node(const Pose2& guess) {
  impl_->nodes.push_back({guess.x, guess.y, guess.theta});
  impl_->problem.AddParameterBlock(impl_->nodes.back().data(), 3);
  if (impl_->nodes.size() == 1) impl_->problem.SetParameterBlockConstant(impl_->nodes.back().data());
  return impl_->nodes.size() - 1;
}

void PoseGraph::add_heading_prior(std::size_t node, double heading_rad, double sigma_rad) {
  impl_->problem.AddResidualBlock(new HeadingCost(heading_rad, sigma_rad), new ceres::CauchyLoss(2),
                                  impl_->nodes.at(node).data());
}

std::size_t PoseGraph::add_odometry(const PoseConstraint& constraint) {
  impl_->add(constraint, impl_->odometry, nullptr);
  return impl_->odometry.size() - 1;
}

void PoseGraph::set_odometry(std::size_t index, const Pose2& T_from_to) {
  impl_->odometry.at(index) = T_from_to;
}

void PoseGraph::add_loop_closure(const PoseConstraint& constraint, double cauchy) {
  impl_->add(constraint, impl_->loop_closures, new ceres::CauchyLoss(cauchy));
}

void PoseGraph::optimise(int iterations_max) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = iterations_max;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &impl_->problem, &summary);
}

std::size_t PoseGraph::size() const {
  return impl_->nodes.size();
}

Pose2 PoseGraph::pose(std::size_t node) const {
  const Node& n = impl_->nodes.at(node);
  return {n[0], n[1], wrap_angle(n[2])};
}

}  // namespace aisle
