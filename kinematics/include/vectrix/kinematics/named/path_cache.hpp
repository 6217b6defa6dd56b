#pragma once

#include <memory>
#include <vectrix/kinematics/named/tree.hpp>

namespace vectrix::detail {

/// A part of a path, for rotations: one edge to evaluate, or the product of consecutive constant edges.
struct PathLeg {
  const EdgeFunction* function;  // null for a fixed rotation
  bool against, in_quaternions;
  Square<double> fixed;
};

/// The path between two frames, prepared once.
struct NamedPath {
  std::vector<PathStep> steps;
  std::vector<PathLeg> legs;

  explicit NamedPath(std::vector<PathStep> found) : steps(std::move(found)) {
    legs.reserve(steps.size());
    for (const PathStep& step : steps) {
      const EdgeFunction& function = step.edge->function();
      const PlacedMotion* fixed = function.constant();
      if (fixed == nullptr) {
        legs.push_back({&function, step.against, function.in_quaternions(), Square<double>::Identity()});
        continue;
      }
      const Square<double> turned =
          step.against ? Square<double>(fixed->turning.R.transpose()) : fixed->turning.R;
      if (legs.empty() || legs.back().function != nullptr) {
        legs.push_back({nullptr, false, false, turned});
      } else {
        legs.back().fixed *= turned;
      }
    }
  }
};

/// Paths by their two ends. Bounded: when it is full it takes no more paths. Never stale: an existing path
/// cannot change, and a missing path is not cached. Any number of threads may read while one adds.
class PathCache {
 public:
  explicit PathCache(std::size_t capacity) : capacity_(capacity) {
    while (mask_ + 1 < 2 * capacity_) mask_ = 2 * mask_ + 1;
    slots_ = std::make_unique<std::atomic<const Entry*>[]>(mask_ + 1);
  }

  const NamedPath* find(std::uint32_t start, std::uint32_t goal) const {
    const std::uint64_t key = key_of(start, goal);
    for (std::size_t slot = slot_of(key);; slot = (slot + 1) & mask_) {
      const Entry* entry = slots_[slot].load(std::memory_order_acquire);
      if (entry == nullptr) return nullptr;
      if (entry->key == key) return &entry->path;
    }
  }

  /// The cached path, from this call or an earlier one; null if the cache is full. Only one thread may call
  /// it at a time.
  const NamedPath* add(std::uint32_t start, std::uint32_t goal, const NamedPath& path) {
    if (const NamedPath* kept = find(start, goal)) return kept;
    if (entries_.size() == capacity_) return nullptr;
    const Entry& entry = entries_.emplace_back(Entry{key_of(start, goal), path});
    std::size_t slot = slot_of(entry.key);
    while (slots_[slot].load(std::memory_order_relaxed) != nullptr) slot = (slot + 1) & mask_;
    slots_[slot].store(&entry, std::memory_order_release);
    return &entry.path;
  }

  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    std::uint64_t key;
    NamedPath path;
  };

  static std::uint64_t key_of(std::uint32_t start, std::uint32_t goal) {
    return static_cast<std::uint64_t>(start) << 32 | goal;
  }
  // Fibonacci hashing: the high half of the product with 2^64 / golden ratio.
  std::size_t slot_of(std::uint64_t key) const {
    return static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> 32) & mask_;
  }

  std::size_t capacity_;
  std::size_t mask_ = 1;
  std::unique_ptr<std::atomic<const Entry*>[]> slots_;
  std::deque<Entry> entries_;
};

}  // namespace vectrix::detail
