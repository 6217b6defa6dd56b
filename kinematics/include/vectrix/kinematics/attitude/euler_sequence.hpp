#pragma once

#include <string>

namespace vectrix {
namespace detail {

/// Whether turns about the three axes reach every attitude: each is 1, 2 or 3, and neighbours differ.
template <int First, int Second, int Third>
inline constexpr bool no_axis_twice_in_a_row = First >= 1 && First <= 3 && Second >= 1 && Second <= 3 &&
                                               Third >= 1 && Third <= 3 && First != Second&& Second != Third;

/// The axes, counted from 0, and their properties that the laws need.
template <int First, int Second, int Third> struct SequenceOfAxes {
  static constexpr int first = First - 1, second = Second - 1, third = Third - 1;
  /// The axis that is neither the first nor the second.
  static constexpr int other = 3 - first - second;
  /// Proper: the third axis is the first, as in 3-1-3. Otherwise all three differ, as in 3-2-1.
  static constexpr bool proper = first == third;
  /// 1 when (first, second, other) is right-handed, else -1.
  static constexpr int handedness = (second - first + 3) % 3 == 1 ? 1 : -1;

  static std::string axes() {
    return std::to_string(First) + "-" + std::to_string(Second) + "-" + std::to_string(Third);
  }
};

}  // namespace detail

/// Three turns, each about an axis of the frame after the previous turns:
///     R_b^a = R_i(t1) R_j(t2) R_k(t3)    Intrinsic<i, j, k>, an axis being 1 (x), 2 (y) or 3 (z)
/// R_i(t) turns by t about axis i, R_3(t) = [cos -sin 0; sin cos 0; 0 0 1]. Intrinsic<3, 2, 1> is yaw, pitch
/// and roll. There are 12 sequences without the same axis twice in a row: see EulerSequence.
template <int First, int Second, int Third> struct Intrinsic : detail::SequenceOfAxes<First, Second, Third> {
  static constexpr bool intrinsic = true;
  static std::string name() { return "intrinsic " + Intrinsic::axes(); }
};
template <int First, int Second, int Third> inline constexpr Intrinsic<First, Second, Third> intrinsic{};

/// Three turns, each about an axis of the fixed frame a:
///     R_b^a = R_k(t3) R_j(t2) R_i(t1)    Extrinsic<i, j, k>
/// The same rotation as Intrinsic<k, j, i> with the angles in reverse order.
template <int First, int Second, int Third> struct Extrinsic : detail::SequenceOfAxes<First, Second, Third> {
  static constexpr bool intrinsic = false;
  static std::string name() { return "extrinsic " + Extrinsic::axes(); }
};
template <int First, int Second, int Third> inline constexpr Extrinsic<First, Second, Third> extrinsic{};

namespace detail {

template <class T> inline constexpr bool is_sequence = false;
template <int I, int J, int K>
inline constexpr bool is_sequence<Intrinsic<I, J, K>> = no_axis_twice_in_a_row<I, J, K>;
template <int I, int J, int K>
inline constexpr bool is_sequence<Extrinsic<I, J, K>> = no_axis_twice_in_a_row<I, J, K>;

}  // namespace detail

/// Intrinsic<i, j, k> or Extrinsic<i, j, k>, where neighbouring axes differ.
template <class T>
concept EulerSequence = detail::is_sequence<T>;

}  // namespace vectrix
