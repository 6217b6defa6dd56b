#include "direction_tree.hpp"

#include <algorithm>
#include <limits>

namespace vectrix::cli {

using Eigen::Vector3d;

// Squares of distances.
struct DirectionTree::Search {
  const Vector3d& from;
  std::size_t begin, end;
  Farthest farthest;

  [[nodiscard]] double bound(const Node& node) const {
    return (node.least - from).cwiseAbs().cwiseMax((node.most - from).cwiseAbs()).squaredNorm();
  }
};

DirectionTree::DirectionTree(const std::vector<Vector3d>& directions)
    : count_(directions.size()), size_(leaf_size), coordinates_(static_cast<Eigen::Index>(count_), 3) {
  for (std::size_t i = 0; i < count_; ++i)
    coordinates_.row(static_cast<Eigen::Index>(i)) = directions[i].transpose();
  while (size_ < count_) size_ *= 2;
  nodes_.resize(2 * size_ / leaf_size);
  build({1, 0, size_});
}

DirectionTree::Place DirectionTree::left(const Place& place) {
  return {2 * place.node, place.begin, (place.begin + place.end) / 2};
}
DirectionTree::Place DirectionTree::right(const Place& place) {
  return {2 * place.node + 1, (place.begin + place.end) / 2, place.end};
}

auto DirectionTree::rows(const Place& place, std::size_t begin, std::size_t end) const {
  const std::size_t from = std::max(begin, place.begin), until = std::min(end, place.end);
  return coordinates_.middleRows(static_cast<Eigen::Index>(from), static_cast<Eigen::Index>(until - from));
}

void DirectionTree::build(const Place& place) {
  Node& node = nodes_[place.node];
  constexpr double infinity = std::numeric_limits<double>::infinity();
  node.least = Vector3d::Constant(infinity);
  node.most = Vector3d::Constant(-infinity);
  if (place.end - place.begin == leaf_size) {
    if (place.begin >= count_) return;
    const auto part = rows(place, 0, count_);
    node.sum = part.colwise().sum();
    node.least = part.colwise().minCoeff();
    node.most = part.colwise().maxCoeff();
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
    sum += rows(place, begin, end).colwise().sum().matrix().transpose();
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

void DirectionTree::search(const Place& place, Search& search) {
  if (search.begin >= place.end || search.end <= place.begin) return;
  Farthest& farthest = search.farthest;
  ++farthest.looks;
  if (!(search.bound(nodes_[place.node]) > farthest.square)) return;
  if (place.end - place.begin == leaf_size) {
    const auto part = rows(place, search.begin, search.end);
    const auto squares = (part.col(0) - search.from.x()).square() + (part.col(1) - search.from.y()).square() +
                         (part.col(2) - search.from.z()).square();
    farthest.looks += leaf_size;
    if (!(squares.maxCoeff() > farthest.square)) return;
    Eigen::Index at = 0;
    farthest.square = squares.maxCoeff(&at);
    farthest.at = std::max(search.begin, place.begin) + static_cast<std::size_t>(at);
    farthest.is_found = true;
    return;
  }
  if (search.begin <= place.begin && place.end <= search.end && place.end - place.begin >= least_near) {
    search_whole(place, search);
  } else {
    search_halves(place, search);
  }
}

bool DirectionTree::is_wide(const Node& node) {
  const double width = (node.most - node.least).maxCoeff();
  return width > 1e-4 && width < 1.9;
}

void DirectionTree::search_whole(const Place& place, Search& search) {
  Node& node = nodes_[place.node];
  if (node.near) {
    node.near->search(search.from, search.farthest);
    return;
  }
  const std::size_t before = search.farthest.looks;
  search_halves(place, search);
  node.looks += search.farthest.looks - before;
  // What it costs to build is then little, compared with what was looked at in vain.
  constexpr std::size_t patience = 32;
  if (node.looks > patience * (place.end - place.begin) && is_wide(node))
    node.near = std::make_unique<const NearTree>(coordinates_, place.begin, place.end);
}

void DirectionTree::search_halves(const Place& place, Search& search) {
  // The half that may hold the farther one comes first.
  const Place halves[] = {left(place), right(place)};
  const bool swap = search.bound(nodes_[halves[1].node]) > search.bound(nodes_[halves[0].node]);
  this->search(halves[swap ? 1 : 0], search);
  this->search(halves[swap ? 0 : 1], search);
}

std::optional<std::size_t> DirectionTree::farthest(const Vector3d& from, std::size_t first, std::size_t last,
                                                   double above) {
  Search search{from, first, last + 1, {above < 0.0 ? -1.0 : above * above, 0}};
  this->search({1, 0, size_}, search);
  looks_ += search.farthest.looks;
  if (!search.farthest.is_found) return std::nullopt;
  return search.farthest.at;
}

}  // namespace vectrix::cli
