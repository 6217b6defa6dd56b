#include "near_tree.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace vectrix::cli {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

Matrix3d principal_axes(const Eigen::Array<double, Eigen::Dynamic, 3>& rows) {
  const Eigen::RowVector3d mean = rows.matrix().colwise().mean();
  const Eigen::MatrixX3d off = rows.matrix().rowwise() - mean;
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(off.transpose() * off).eigenvectors().transpose();
}

}  // namespace

NearTree::NearTree(const Eigen::Array<double, Eigen::Dynamic, 3>& rows, std::size_t first, std::size_t end)
    : axes_(principal_axes(
          rows.middleRows(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(end - first)))),
      first_(first),
      places_(end - first),
      boxes_(4 * (end - first) / leaf_size + 2) {
  for (std::size_t i = first; i < end; ++i)
    points_.emplace_back(axes_ * rows.row(static_cast<Eigen::Index>(i)).matrix().transpose());
  std::iota(places_.begin(), places_.end(), std::uint32_t{0});
  build(1, 0, places_.size());
  std::vector<Vector3d> in_order;
  for (const std::uint32_t place : places_) in_order.push_back(points_[place]);
  points_ = std::move(in_order);
}

// points_ are still in the order of the rows.
void NearTree::build(std::size_t node, std::size_t begin, std::size_t end) {
  Box& box = boxes_[node];
  box.least = box.most = points_[places_[begin]];
  for (std::size_t i = begin; i < end; ++i) {
    box.least = box.least.cwiseMin(points_[places_[i]]);
    box.most = box.most.cwiseMax(points_[places_[i]]);
  }
  if (end - begin <= leaf_size) return;
  Eigen::Index widest = 0;
  (box.most - box.least).maxCoeff(&widest);
  const std::size_t middle = (begin + end) / 2;
  const auto at = [&](std::size_t i) { return places_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [&](std::uint32_t a, std::uint32_t b) { return points_[a][widest] < points_[b][widest]; });
  build(2 * node, begin, middle);
  build(2 * node + 1, middle, end);
}

void NearTree::search(const Vector3d& from, Farthest& farthest) const {
  search(1, 0, places_.size(), axes_ * from, farthest);
}

void NearTree::search(std::size_t node, std::size_t begin, std::size_t end, const Vector3d& from,
                      Farthest& farthest) const {
  const auto bound = [&](std::size_t of) {
    ++farthest.looks;
    const Box& box = boxes_[of];
    const double by_corner =
        (box.least - from).cwiseAbs().cwiseMax((box.most - from).cwiseAbs()).squaredNorm();
    // |u - f|^2 = |u|^2 + |f|^2 - 2 u . f, which is linear in the unit vector u.
    constexpr double rounding = 1e-15;
    const double by_product = 1.0 + from.squaredNorm() -
                              2.0 * box.least.cwiseProduct(from).cwiseMin(box.most.cwiseProduct(from)).sum() +
                              rounding;
    return std::min(by_corner, by_product);
  };
  // A unit vector is rounded by 1e-16; so a box whose corner is farther by no more holds no farther one.
  constexpr double rounding = 2e-15;
  const auto may_hold = [&](double square) {
    return square > farthest.square + 2.0 * rounding * std::sqrt(std::max(farthest.square, 0.0));
  };
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i) {
      ++farthest.looks;
      const double square = (points_[i] - from).squaredNorm();
      if (!(square > farthest.square)) continue;
      farthest.square = square;
      farthest.at = first_ + places_[i];
      farthest.is_found = true;
    }
    return;
  }
  const std::size_t middle = (begin + end) / 2, left = 2 * node, right = left + 1;
  const double of_left = bound(left), of_right = bound(right);
  const bool swap = of_right > of_left;
  for (const bool is_right : {swap, !swap})
    if (may_hold(is_right ? of_right : of_left))
      search(is_right ? right : left, is_right ? middle : begin, is_right ? end : middle, from, farthest);
}

}  // namespace vectrix::cli
