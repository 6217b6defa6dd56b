#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vectrix::cli {

/// The farthest direction that a search has found.
struct Farthest {
  double square;  // of its distance
  std::size_t at;
  bool is_found = false;
  std::size_t looks = 0;  // at how many directions and boxes it has looked
};

/// Directions by where they are, not by their order: a binary tree of boxes along the principal axes of all.
/// Of a spin these are its axis and two across, so that the boxes of a circle are flat, and all but a few are
/// left aside even if all directions are nearly as far. The distance found is the largest but for 2e-15.
class NearTree {
 public:
  /// Of the rows, the first of which is number `first`.
  NearTree(const Eigen::Array<double, Eigen::Dynamic, 3>& rows, std::size_t first, std::size_t end);

  void search(const Eigen::Vector3d& from, Farthest& farthest) const;

 private:
  struct Box {
    Eigen::Vector3d least, most;
  };
  static constexpr std::size_t leaf_size = 16;

  void build(std::size_t node, std::size_t begin, std::size_t end);
  void search(std::size_t node, std::size_t begin, std::size_t end, const Eigen::Vector3d& from,
              Farthest& farthest) const;

  Eigen::Matrix3d axes_;  // its rows
  std::size_t first_;
  std::vector<Eigen::Vector3d> points_;  // along these axes, in the order of the tree
  std::vector<std::uint32_t> places_;    // of the points, from the first row on
  std::vector<Box> boxes_;
};

}  // namespace vectrix::cli
