#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>
#include <vectrix/kinematics/named/edge.hpp>

namespace vectrix::detail {

/// A frame in a rooted tree. Immutable: when its tree is joined to another, its frame gets a new node. The
/// old node remains for threads that still read it.
struct TreeNode {
  const FrameRecord* frame;
  const NamedEdge* edge;  // to the parent; null at the root
  const TreeNode* parent;
  const TreeNode* root;
  std::size_t depth;
};

/// An edge and its direction on the path; `against` if from its second frame, `from()`, to its first.
struct PathStep {
  const NamedEdge* edge;
  bool against;
  bool operator==(const PathStep&) const = default;
};

inline bool is_against(const NamedEdge& edge, const FrameRecord& start) {
  return &edge.from().record() == &start;
}

/// The steps between two nodes with the same root. Edges are only added and never close a cycle, so a path
/// stays the only one.
inline std::vector<PathStep> steps_between(const TreeNode* start, const TreeNode* goal) {
  std::vector<PathStep> steps(start->depth + goal->depth);
  auto front = steps.begin();
  auto back = steps.end();
  while (start != goal) {
    if (start->depth >= goal->depth) {
      *front++ = {start->edge, is_against(*start->edge, *start->frame)};
      start = start->parent;
    } else {
      *--back = {goal->edge, !is_against(*goal->edge, *goal->frame)};
      goal = goal->parent;
    }
  }
  steps.erase(front, back);
  return steps;
}

/// The trees of a graph. Only one thread changes them at a time; others may read the nodes in the frame
/// records.
class NamedTrees {
 public:
  void add(FrameRecord& frame) {
    TreeNode& node = nodes_.emplace_back(TreeNode{&frame, nullptr, nullptr, nullptr, 0});
    node.root = &node;
    places_.push_back({&frame, {}});
    size_.push_back(1);
    frame.node.store(&node, std::memory_order_release);
  }

  /// The edge between these two frames; null if there is none.
  const NamedEdge* find(const FrameRecord& a, const FrameRecord& b) const {
    const bool at_a = places_[a.number].edges.size() <= places_[b.number].edges.size();
    const FrameRecord& end = at_a ? a : b;
    for (const NamedEdge* edge : places_[end.number].edges)
      if (&other_end(*edge, end) == (at_a ? &b : &a)) return edge;
    return nullptr;
  }

  /// Joins two trees. The smaller gets a new root, at its end of the edge, so n edges make at most n log2 n
  /// nodes.
  void join(const NamedEdge& edge) {
    const FrameRecord* below = &edge.to().record();
    const FrameRecord* above = &edge.from().record();
    const auto root_number = [](const FrameRecord& frame) {
      return frame.node.load(std::memory_order_relaxed)->root->frame->number;
    };
    if (size_[root_number(*below)] > size_[root_number(*above)]) std::swap(below, above);
    size_[root_number(*above)] += size_[root_number(*below)];

    struct Hanging {
      const FrameRecord* frame;
      const NamedEdge* edge;
      const TreeNode* parent;
    };
    std::vector<Hanging> open{{below, &edge, above->node.load(std::memory_order_relaxed)}};
    while (!open.empty()) {
      const Hanging next = open.back();
      open.pop_back();
      const TreeNode& node = nodes_.emplace_back(
          TreeNode{next.frame, next.edge, next.parent, next.parent->root, next.parent->depth + 1});
      for (const NamedEdge* beyond : places_[next.frame->number].edges)
        if (beyond != next.edge) open.push_back({&other_end(*beyond, *next.frame), beyond, &node});
      places_[next.frame->number].frame->node.store(&node, std::memory_order_release);
    }
    places_[below->number].edges.push_back(&edge);
    places_[above->number].edges.push_back(&edge);
  }

 private:
  struct Place {
    FrameRecord* frame;
    std::vector<const NamedEdge*> edges;
  };

  static const FrameRecord& other_end(const NamedEdge& edge, const FrameRecord& end) {
    return is_against(edge, end) ? edge.to().record() : edge.from().record();
  }

  std::deque<TreeNode> nodes_;
  std::vector<Place> places_;      // by frame number
  std::vector<std::size_t> size_;  // of the tree whose root has that number
};

}  // namespace vectrix::detail
