#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "near_tree.hpp"

namespace vectrix::cli {

/// Directions in their order, for sums and farthest ones of any stretch of them: a binary tree, whose nodes
/// have the sum and the box of theirs. A sum takes of the order of log n steps. The search for the farthest
/// one enters only boxes that may hold a farther one than was found: the result is that of looking at each,
/// in of the order of log n steps if few are nearly as far. If nearly all are, as in a spin, a node in which
/// much was looked at in vain gets a NearTree: then it is of the order of log^2 n, and the distance is the
/// largest but for 2e-15.
class DirectionTree {
 public:
  explicit DirectionTree(const std::vector<Eigen::Vector3d>& directions);

  /// Of first to last, both included.
  [[nodiscard]] Eigen::Vector3d sum(std::size_t first, std::size_t last) const;
  /// The one of first to last whose distance from `from` is the largest, or nothing if none is above `above`.
  [[nodiscard]] std::optional<std::size_t> farthest(const Eigen::Vector3d& from, std::size_t first,
                                                    std::size_t last, double above);
  /// At how many directions and boxes the searches have looked so far.
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  struct Node {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d least, most;
    std::size_t looks = 0;
    std::unique_ptr<const NearTree> near{};
  };
  // Directions begin to end, which the node is of.
  struct Place {
    std::size_t node, begin, end;
  };
  static constexpr std::size_t leaf_size = 64, least_near = 512;
  // So that 2e-15 is nothing, and no angle is near pi, where it were more.
  [[nodiscard]] static bool is_wide(const Node& node);

  [[nodiscard]] static Place left(const Place& place);
  [[nodiscard]] static Place right(const Place& place);
  // Of a leaf, those of begin to end that exist.
  [[nodiscard]] auto rows(const Place& place, std::size_t begin, std::size_t end) const;
  void build(const Place& place);
  void add(const Place& place, std::size_t begin, std::size_t end, Eigen::Vector3d& sum) const;
  struct Search;
  void search(const Place& place, Search& search);
  void search_halves(const Place& place, Search& search);
  void search_whole(const Place& place, Search& search);

  std::size_t count_;
  std::size_t size_;  // leaf_size times a power of two
  std::vector<Node> nodes_;
  std::size_t looks_ = 0;
  Eigen::Array<double, Eigen::Dynamic, 3> coordinates_;  // column by column: two at a time are looked at
};

}  // namespace vectrix::cli
