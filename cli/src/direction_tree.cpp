#include "direction_tree.hpp"

#include <algorithm>
#include <limits>

namespace vectrix::cli {

using Eigen::Vector3d;

// Squares of distances.
struct DirectionTree::Search {
  const Vector3d& from;
  std::size_t begin, end;
  double largest;
  std::optional<std::size_t> found{};

  [[nodiscard]] double bound(const Node& node) const {
    return (node.least - from).cwiseAbs().cwiseMax((node.most - from).cwiseAbs()).squaredNorm();
  }
};

DirectionTree::DirectionTree(const std::vector<Vector3d>& directions)
    : directions_(directions), size_(leaf_size) {
  while (size_ < directions.size()) size_ *= 2;
  nodes_.resize(2 * size_ / leaf_size);
  build({1, 0, size_});
}

DirectionTree::Place DirectionTree::left(const Place& place) {
  return {2 * place.node, place.begin, (place.begin + place.end) / 2};
}
DirectionTree::Place DirectionTree::right(const Place& place) {
  return {2 * place.node + 1, (place.begin + place.end) / 2, place.end};
}

void DirectionTree::build(const Place& place) {
  Node& node = nodes_[place.node];
  constexpr double infinity = std::numeric_limits<double>::infinity();
  node.least = Vector3d::Constant(infinity);
  node.most = Vector3d::Constant(-infinity);
  if (place.end - place.begin == leaf_size) {
    for (std::size_t i = place.begin; i < std::min(place.end, directions_.size()); ++i) {
      node.sum += directions_[i];
      node.least = node.least.cwiseMin(directions_[i]);
      node.most = node.most.cwiseMax(directions_[i]);
    }
    return;
  }
  for (const Place& half : {left(place), right(place)}) {
    build(half);
    const Node& part = nodes_[half.node];
    node.sum += part.sum;
    node.least = node.least.cwiseMin(part.least);
    node.most = node.most.cwiseMax(part.most);
  }
}

void DirectionTree::add(const Place& place, std::size_t begin, std::size_t end, Vector3d& sum) const {
  if (begin >= place.end || end <= place.begin) return;
  if (begin <= place.begin && place.end <= end) {
    sum += nodes_[place.node].sum;
  } else if (place.end - place.begin == leaf_size) {
    for (std::size_t i = std::max(begin, place.begin); i < std::min(end, place.end); ++i)
      sum += directions_[i];
  } else {
    add(left(place), begin, end, sum);
    add(right(place), begin, end, sum);
  }
}

Vector3d DirectionTree::sum(std::size_t first, std::size_t last) const {
  Vector3d sum = Vector3d::Zero();
  add({1, 0, size_}, first, last + 1, sum);
  return sum;
}

void DirectionTree::search(const Place& place, Search& search) const {
  if (search.begin >= place.end || search.end <= place.begin) return;
  if (!(search.bound(nodes_[place.node]) > search.largest)) return;
  if (place.end - place.begin == leaf_size) {
    for (std::size_t i = std::max(search.begin, place.begin); i < std::min(search.end, place.end); ++i) {
      const double square = (directions_[i] - search.from).squaredNorm();
      if (!(square > search.largest)) continue;
      search.largest = square;
      search.found = i;
    }
    return;
  }
  // The half that may hold the farther one comes first.
  const Place halves[] = {left(place), right(place)};
  const bool swap = search.bound(nodes_[halves[1].node]) > search.bound(nodes_[halves[0].node]);
  this->search(halves[swap ? 1 : 0], search);
  this->search(halves[swap ? 0 : 1], search);
}

std::optional<std::size_t> DirectionTree::farthest(const Vector3d& from, std::size_t first, std::size_t last,
                                                   double above) const {
  Search search{from, first, last + 1, above < 0.0 ? -1.0 : above * above};
  this->search({1, 0, size_}, search);
  return search.found;
}

}  // namespace vectrix::cli
