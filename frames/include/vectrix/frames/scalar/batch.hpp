#pragma once

#include <cmath>
#include <cstddef>

/// What the library needs of a scalar beyond arithmetic, also of a batch of numbers.
namespace vectrix::detail {

/// Several numbers, one per lane, such as std::experimental::simd. A comparison gives a mask, not a bool, and
/// `if` takes no mask. So algorithms for batches cannot branch on values.
template <class S>
concept Batch = requires(const S& numbers) {
  typename S::value_type;
  typename S::mask_type;
  S::size();
  numbers[0];
};

/// A number with its derivatives, such as Eigen::AutoDiffScalar.
template <class S>
concept Differentiated = requires(const S& number) {
  number.derivatives();
};

/// The number without derivatives: Eigen has no absolute value, root or arc tangent for nested derivatives.
template <class S> auto without_derivatives(const S& x) {
  if constexpr (Differentiated<S>) {
    return without_derivatives(x.value());
  } else {
    return x;
  }
}

/// Whether a comparison holds: for one number, or in every lane.
inline bool all(bool holds) {
  return holds;
}
template <class Mask> bool all(const Mask& holds) {
  return all_of(holds);
}

/// `yes` where the condition holds, else `no`, lane by lane. Both are evaluated.
template <class S> S select(bool holds, const S& yes, const S& no) {
  return holds ? yes : no;
}
/// By value: g++ 12 writes `x = {select(holds, x.member, other), ...}` to x while it still reads x.
template <Batch S> [[gnu::always_inline]] inline S select(typename S::mask_type holds, S yes, S no) {
  where(holds, no) = yes;
  return no;
}

/// Converts a double to S: a batch of floats has no conversion from double.
template <class S> S number(double x) {
  return S(x);
}
template <Batch S> S number(double x) {
  return S(typename S::value_type(x));
}

/// f of each lane.
template <Batch S, class Function> S each_lane(const S& x, const Function& f) {
  return S([&](auto i) { return f(typename S::value_type(x[i])); });
}

/// Whether every entry of a matrix is finite, in every lane. A loop: each user compiles it, and expressions
/// of Eigen's take longer.
template <class Matrix> bool all_finite(const Matrix& matrix) {
  using S = typename Matrix::Scalar;
  const auto& numbers = matrix.eval();  // a matrix itself, the value of an expression
  S zero = S(0);
  for (auto row = numbers.rows(); row-- > 0;)
    for (auto column = numbers.cols(); column-- > 0;) zero += numbers(row, column) - numbers(row, column);
  return all(zero == S(0));
}

/// The matrix of the numbers of one lane.
template <class Matrix> auto lane(const Matrix& matrix, std::size_t i) {
  using Number = typename Matrix::Scalar::value_type;
  return matrix.unaryExpr([i](const auto& x) { return Number(x[i]); }).eval();
}

}  // namespace vectrix::detail
