#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <memory>
#include <vector>
#include <vectrix/kinematics/named/frame.hpp>

namespace vectrix::detail {

/// Maps a key (a name, a type) to a frame, by open addressing. Any number of threads may read while one adds;
/// nothing is removed. A table that is half full is replaced by one of twice the size. Old tables are kept
/// for readers that still use them; together they are no larger than the current one.
template <class Key> class FrameIndex {
 public:
  FrameIndex() { publish(16); }

  /// The frame of that key; null if there is none.
  const FrameRecord* find(const Key& key) const {
    const std::size_t hash = std::hash<Key>{}(key);
    const Table& table = *table_.load(std::memory_order_acquire);
    for (std::size_t slot = hash & table.mask;; slot = (slot + 1) & table.mask) {
      const Entry* entry = table.slots[slot].load(std::memory_order_acquire);
      if (entry == nullptr) return nullptr;
      if (entry->hash == hash && entry->key == key) return entry->frame;
    }
  }

  /// Adds a new key. Only one thread may call it at a time.
  void add(const Key& key, const FrameRecord& frame) {
    if (2 * (entries_.size() + 1) > tables_.back()->mask + 1) publish(2 * (tables_.back()->mask + 1));
    insert(*tables_.back(), entries_.emplace_back(Entry{key, std::hash<Key>{}(key), &frame}));
  }

 private:
  struct Entry {
    Key key;
    std::size_t hash;
    const FrameRecord* frame;
  };
  struct Table {
    explicit Table(std::size_t size)
        : mask(size - 1), slots(std::make_unique<std::atomic<const Entry*>[]>(size)) {}
    std::size_t mask;
    std::unique_ptr<std::atomic<const Entry*>[]> slots;
  };

  static void insert(Table& table, const Entry& entry) {
    std::size_t slot = entry.hash & table.mask;
    while (table.slots[slot].load(std::memory_order_relaxed) != nullptr) slot = (slot + 1) & table.mask;
    table.slots[slot].store(&entry, std::memory_order_release);
  }

  void publish(std::size_t size) {
    auto table = std::make_unique<Table>(size);
    for (const Entry& entry : entries_) insert(*table, entry);
    tables_.push_back(std::move(table));
    table_.store(tables_.back().get(), std::memory_order_release);
  }

  std::deque<Entry> entries_;
  std::vector<std::unique_ptr<Table>> tables_;
  std::atomic<const Table*> table_;
};

}  // namespace vectrix::detail
