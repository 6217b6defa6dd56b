#pragma once

#include <array>
#include <cstddef>

#include <vectrix/frames/vector.hpp>

namespace vectrix::detail {

inline constexpr int largest_degree = 15;

/// A polynomial and its first two derivatives at one time.
template <class S> struct PolynomialValues { Column<S> value, first, second; };

/// The polynomial through values at given times, by Newton's divided differences,
///     p(t) = c_0 + (t - z_0)(c_1 + (t - z_1)(c_2 + ...)),  c_k = f[z_0, ..., z_k]
/// A time that is added twice in a row has the derivative that is given, too.
template <class S, int Degree = largest_degree> class NewtonPolynomial {
 public:
  NewtonPolynomial() {
    times_.fill(S(0));
    differences_.fill(Column<S>::Zero());
    derivatives_.fill(Column<S>::Zero());
  }

  void add(const S& time, const Column<S>& value) {
    times_[size_] = time;
    differences_[size_] = value;
    ++size_;
  }
  void add(const S& time, const Column<S>& value, const Column<S>& derivative) {
    add(time, value);
    derivatives_[size_] = derivative;
    add(time, value);
  }

  /// Of what was added; then no more can be added.
  void divide() {
    for (std::size_t k = 1; k < size_; ++k) {
      for (std::size_t i = size_ - 1; i >= k; --i) {
        const S apart = times_[i] - times_[i - k];
        if (apart == S(0)) {
          differences_[i] = derivatives_[i];
        } else {
          differences_[i] = Column<S>((differences_[i] - differences_[i - 1]) / apart);
        }
      }
    }
  }
  PolynomialValues<S> at(const S& t) const {
    PolynomialValues<S> p{differences_[size_ - 1], Column<S>::Zero(), Column<S>::Zero()};
    for (std::size_t k = size_ - 1; k-- > 0;) {
      const S since = t - times_[k];
      p.second = Column<S>(since * p.second + S(2) * p.first);
      p.first = Column<S>(since * p.first + p.value);
      p.value = Column<S>(since * p.value + differences_[k]);
    }
    return p;
  }

 private:
  template <class T> using Nodes = std::array<T, static_cast<std::size_t>(Degree) + 1>;

  std::size_t size_ = 0;
  Nodes<S> times_;
  Nodes<Column<S>> differences_, derivatives_;
};

}  // namespace vectrix::detail
