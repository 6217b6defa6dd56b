#pragma once

#include <mutex>
#include <typeindex>
#include <vectrix/kinematics/named/index.hpp>
#include <vectrix/kinematics/named/nearest_name.hpp>
#include <vectrix/kinematics/named/walk.hpp>

namespace vectrix::detail {

/// The state of a NamedGraph. Additions hold the mutex. Readers use atomically published data without it;
/// they lock it only to add a path to the cache and to confirm that there is no path.
class NamedGraphCore {
 public:
  explicit NamedGraphCore(std::size_t cached_paths) : cache_(cached_paths) {}

  // `type` is null for a frame without one.
  NamedFrame add_frame(std::string name, FrameMotion motion, const std::type_info* type) {
    const std::lock_guard lock(mutex_);
    if (name.empty()) throw BadInput("add_frame: the name is empty");
    if (names_.find(name)) throw BadInput("add_frame: the graph has a frame " + in_quotes(name) + " already");
    if (type != nullptr) require_unbound(*type, "add_frame");
    FrameRecord& frame = frames_.emplace_back();
    frame.graph = this;
    frame.name = std::move(name);
    frame.motion = motion;
    frame.number = static_cast<std::uint32_t>(frames_.size() - 1);
    trees_.add(frame);
    if (type != nullptr) types_.add(*type, frame);
    bound_.push_back(type != nullptr);
    names_.add(frame.name, frame);
    return NamedFrame{frame};
  }

  void bind(const std::type_info& type, const std::string& type_name, FrameMotion motion,
            const FrameRecord& frame) {
    const std::lock_guard lock(mutex_);
    const std::string action = "bind<" + type_name + ">(" + in_quotes(frame.name) + ")";
    require_unbound(type, action);
    if (bound_[frame.number]) throw BadInput(action + ": the frame is bound to a type already");
    if (motion != frame.motion) {
      const auto word = [](FrameMotion m) { return m == FrameMotion::inertial ? "inertial" : "moving"; };
      throw BadInput(action + ": the type is " + word(motion) + ", the frame " + word(frame.motion));
    }
    bound_[frame.number] = true;
    types_.add(type, frame);
  }

  void add_edge(NamedEdge edge) {
    const std::string action =
        "add_edge(to " + in_quotes(edge.to()) + ", from " + in_quotes(edge.from()) + ")";
    const FrameRecord& a = of_this_graph(edge.to());
    const FrameRecord& b = of_this_graph(edge.from());
    if (const PlacedMotion* fixed = edge.function().constant()) {
      if (!fixed->turning.R.allFinite()) throw BadInput(action + ": the rotation is not finite");
      if (edge.placed() && !fixed->r.allFinite()) throw BadInput(action + ": the position is not finite");
    }
    const std::lock_guard lock(mutex_);
    if (&a == &b) throw BadInput(action + ": an edge joins two frames");
    if (trees_.find(a, b)) throw BadInput(action + ": the graph has an edge between the two already");
    if (root(a) == root(b)) throw BadInput(action + ": it would close a cycle, " + joined(a, b));
    trees_.join(edges_.emplace_back(std::move(edge)));
  }

  // The frame given by a handle, a name or a type.
  const FrameRecord& record(NamedFrame frame) const { return of_this_graph(frame); }
  const FrameRecord& record(std::string_view name) const {
    const FrameRecord* found = names_.find(name);
    if (found == nullptr) [[unlikely]]
      refuse_name(name);
    return *found;
  }
  template <Frame F> const FrameRecord& record() const {
    const FrameRecord* found = types_.find(typeid(F));
    if (found == nullptr) throw BadInput("no frame of the graph is bound to the type " + frame_name<F>());
    return *found;
  }

  std::vector<NamedFrame> frames() const {
    const std::lock_guard lock(mutex_);
    return {frames_.begin(), frames_.end()};
  }
  std::size_t cached_paths() const {
    const std::lock_guard lock(mutex_);
    return cache_.size();
  }

  /// Calls `use(path)` with the path from start to goal; null if they are in two trees.
  template <class Use>
  decltype(auto) with_path(const FrameRecord& start, const FrameRecord& goal, const Use& use) const {
    if (const NamedPath* kept = cache_.find(start.number, goal.number)) [[likely]]
      return use(kept);
    return with_new_path(start, goal, use);
  }

 private:
  template <class Use>
  [[gnu::noinline]] decltype(auto) with_new_path(const FrameRecord& start, const FrameRecord& goal,
                                                 const Use& use) const {
    const TreeNode* from = start.node.load(std::memory_order_acquire);
    const TreeNode* until = goal.node.load(std::memory_order_acquire);
    if (from->root != until->root) {
      // Two trees, or nodes from before and after a join: the lock excludes a join.
      const std::lock_guard lock(mutex_);
      from = start.node.load(std::memory_order_relaxed);
      until = goal.node.load(std::memory_order_relaxed);
    }
    if (from->root != until->root) return use(static_cast<const NamedPath*>(nullptr));
    const NamedPath found(steps_between(from, until));
    const NamedPath* kept = nullptr;
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock.owns_lock())
      kept = cache_.add(start.number, goal.number, found);
    return use(kept != nullptr ? kept : &found);
  }

  const FrameRecord& of_this_graph(NamedFrame frame) const {
    if (frame.record().graph != this) [[unlikely]]
      throw BadInput("the frame " + in_quotes(frame) + " belongs to another graph");
    return frame.record();
  }

  static const TreeNode* root(const FrameRecord& frame) {
    return frame.node.load(std::memory_order_relaxed)->root;
  }

  static std::string joined(const FrameRecord& a, const FrameRecord& b) {
    std::string text = in_quotes(a.name);
    for (const PathStep& step : steps_between(a.node.load(), b.node.load()))
      text += " - " + in_quotes(step.against ? step.edge->to() : step.edge->from());
    return text;
  }

  void require_unbound(const std::type_info& type, const std::string& action) const {
    if (const FrameRecord* frame = types_.find(type))
      throw BadInput(action + ": the type is bound to the frame " + in_quotes(frame->name) + " already");
  }

  [[noreturn, gnu::cold, gnu::noinline]] void refuse_name(std::string_view name) const {
    const std::lock_guard lock(mutex_);
    std::vector<std::string_view> names;
    for (const FrameRecord& frame : frames_) names.push_back(frame.name);
    const std::string_view nearest = nearest_name(name, names);
    throw BadInput("no frame " + in_quotes(name) + " in the graph" +
                   (nearest.empty() ? ", which has " + text(frames_.size()) + " frames"
                                    : "; the nearest name is " + in_quotes(nearest)));
  }

  mutable std::mutex mutex_;
  std::deque<FrameRecord> frames_;
  std::vector<bool> bound_;  // whether bound to a type, by frame number
  std::deque<NamedEdge> edges_;
  NamedTrees trees_;
  FrameIndex<std::string_view> names_;
  FrameIndex<std::type_index> types_;
  mutable PathCache cache_;
};

}  // namespace vectrix::detail
