#pragma once

#include <cmath>
#include <cstddef>

/// What the library asks of a scalar beyond its arithmetic, also of one that is several numbers at once.
namespace vectrix::detail {

/// Several numbers, one a lane, as std::experimental::simd. What is true of some lanes and false of others is
/// a mask and no bool: no `if` takes it, so the algebra of batches cannot branch on their numbers.
template <class S>
concept Batch = requires(const S& numbers) {
  typename S::value_type;
  typename S::mask_type;
  S::size();
  numbers[0];
};

/// A number with its derivatives, as Eigen::AutoDiffScalar.
template <class S>
concept Differentiated = requires(const S& number) {
  number.derivatives();
};

/// The number alone: Eigen has no absolute value, root or arc tangent of nested derivatives.
template <class S> auto without_derivatives(const S& x) {
  if constexpr (Differentiated<S>) {
    return without_derivatives(x.value());
  } else {
    return x;
  }
}

/// Whether a comparison holds: of one number, or in every lane.
inline bool all(bool holds) {
  return holds;
}
template <class Mask> bool all(const Mask& holds) {
  return all_of(holds);
}

/// `yes` where the condition holds, `no` elsewhere, lane by lane; both are computed.
template <class S> S select(bool holds, const S& yes, const S& no) {
  return holds ? yes : no;
}
/// By value: g++ 12 builds `x = {select(holds, x.member, other), ...}` in the place of what it still reads.
template <Batch S> [[gnu::always_inline]] inline S select(typename S::mask_type holds, S yes, S no) {
  where(holds, no) = yes;
  return no;
}

/// A double as a scalar: a batch of floats takes no double.
template <class S> S number(double x) {
  return S(x);
}
template <Batch S> S number(double x) {
  return S(typename S::value_type(x));
}

/// f of each lane alone.
template <Batch S, class Function> S each_lane(const S& x, const Function& f) {
  return S([&](auto i) { return f(typename S::value_type(x[i])); });
}

/// Whether every entry of a matrix is finite, in every lane.
template <class Matrix> bool all_finite(const Matrix& matrix) {
  using S = typename Matrix::Scalar;
  if constexpr (Batch<S>) {
    return all(S((matrix - matrix).sum()) == S(0));
  } else {
    return matrix.allFinite();
  }
}

/// A matrix of one lane's numbers.
template <class Matrix> auto lane(const Matrix& matrix, std::size_t i) {
  using Number = typename Matrix::Scalar::value_type;
  return matrix.unaryExpr([i](const auto& x) { return Number(x[i]); }).eval();
}

}  // namespace vectrix::detail
