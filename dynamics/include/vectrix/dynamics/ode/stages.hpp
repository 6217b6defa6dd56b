#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace vectrix::ode::detail {

/// The numbers of a state. An odd size gets one more number, always 0, so that two fit one register.
template <std::size_t N> class Numbers {
 public:
  explicit Numbers(std::size_t) {}
  static constexpr std::size_t width() { return N + N % 2; }
  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }
  double& operator[](std::size_t i) { return values_[i]; }
  double operator[](std::size_t i) const { return values_[i]; }

 private:
  alignas(16) std::array<double, N + N % 2> values_{};
};

template <> class Numbers<std::dynamic_extent> {
 public:
  explicit Numbers(std::size_t size) : values_(size + size % 2) {}
  std::size_t width() const { return values_.size(); }
  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }
  double& operator[](std::size_t i) { return values_[i]; }
  double operator[](std::size_t i) const { return values_[i]; }

 private:
  std::vector<double> values_;
};

/// The rates of all stages, and what one operation takes of them: one number, as the compiler makes the loops
/// over a fixed size parallel itself.
template <std::size_t N, std::size_t count> class Stages {
 public:
  using Group = double;
  static constexpr std::size_t group_size = 1;
  static Numbers<N>& row(Numbers<N>& numbers) { return numbers; }
  static const Numbers<N>& row(const Numbers<N>& numbers) { return numbers; }
  static Group load(const Numbers<N>& row, std::size_t c) { return row[c]; }
  static void store(Numbers<N>& row, std::size_t c, Group group) { row[c] = group; }

  explicit Stages(std::size_t size) : rows_(rows(size, std::make_index_sequence<count>{})) {}
  Numbers<N>& operator[](std::size_t stage) { return rows_[stage]; }
  const Numbers<N>& operator[](std::size_t stage) const { return rows_[stage]; }
  /// To be called when the rates of a stage have been written.
  void pack(std::size_t) {}
  const Stages& packed() const { return *this; }
  Group group(std::size_t stage, std::size_t c) const { return rows_[stage][c]; }

 private:
  template <std::size_t... I>
  static std::array<Numbers<N>, count> rows(std::size_t size, std::index_sequence<I...>) {
    return {((void)I, Numbers<N>(size))...};
  }
  std::array<Numbers<N>, count> rows_;
};

/// Of a size known at run time: two numbers, in a copy where those of all stages stand together. Their
/// distance is then a constant, and a loop has one pointer.
template <std::size_t count> class Stages<std::dynamic_extent, count> {
 public:
  typedef double Group [[gnu::vector_size(16)]];
  static constexpr std::size_t group_size = 2;
  static double* row(Numbers<std::dynamic_extent>& numbers) { return numbers.data(); }
  static const double* row(const Numbers<std::dynamic_extent>& numbers) { return numbers.data(); }
  static Group load(const double* row, std::size_t c) {
    Group group;
    std::memcpy(&group, std::assume_aligned<sizeof group>(row + c), sizeof group);
    return group;
  }
  static void store(double* row, std::size_t c, const Group& group) {
    std::memcpy(std::assume_aligned<sizeof group>(row + c), &group, sizeof group);
  }

  explicit Stages(std::size_t size)
      : rows_(count, Numbers<std::dynamic_extent>(size)), packed_(rows_[0].width() * count) {}
  Numbers<std::dynamic_extent>& operator[](std::size_t stage) { return rows_[stage]; }
  const Numbers<std::dynamic_extent>& operator[](std::size_t stage) const { return rows_[stage]; }
  void pack(std::size_t stage) {
    const double* row = rows_[stage].data();
    const std::size_t width = rows_[stage].width();
    double* to = packed_.data() + group_size * stage;
    for (std::size_t c = 0; c < width; c += group_size, to += group_size * count)
      store(to, 0, Group{row[c], row[c + 1]});
  }
  struct Packed {
    const double* numbers;
    Group group(std::size_t stage, std::size_t c) const {
      return load(numbers, count * c + group_size * stage);
    }
  };
  Packed packed() const { return {packed_.data()}; }

 private:
  std::vector<Numbers<std::dynamic_extent>> rows_;
  std::vector<double> packed_;
};

}  // namespace vectrix::ode::detail
