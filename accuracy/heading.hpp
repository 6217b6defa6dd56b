#pragma once

namespace vectrix::accuracy {

inline constexpr const char* heading = R"(# Accuracy

Written by `./dev validate`. This page gives the error of every function in double precision. The reference is computed in
`long double` with 64 binary digits, from exactly the same double numbers.

- **ulp**: an error e is |e| / (2^-52 scale) ulp. |e| is the Euclidean norm of the difference of vectors or quaternions, and
  the Frobenius norm of the difference of matrices. A rounding to nearest is at most half an ulp. Each row names its *scale*:
  1 for rotations, the size of the exact result for most others, the sum of the sizes of the terms where they may cancel.
- **The input is the number that is given.** A matrix or a quaternion of doubles is not exactly a rotation, because its entries
  are rounded. The expected result is that of the nearest rotation, or of q/|q|, in exact arithmetic. In sums and products the
  given numbers are used as they are. So the rounding of the input is part of the error, as far as a function lets it through.
- **One rotation has several sets of numbers.** The sign of a quaternion does not count, and at half a turn either axis is
  right. Where the numbers are ill-conditioned, as Euler angles near gimbal lock, the row says *backward*: the error is the angle
  between the given rotation and the rotation of the numbers found.
- **Two kinds of reference.** For exponentials, logarithms, Jacobians, angles and motions the reference is an *independent*
  formula, named above each table. For sums and products it is *rounding alone*: the same formula in `long double`. The tests
  check that this formula is right.
- **The promise** is the number of roundings, half an ulp each, as if all had the same sign, times the largest factor by which one
  of them can grow in the domain. A row fails if its error is larger. The test suite measures the same rows with fewer samples.
- **Seam**: an input at which a function changes from one formula to another, for example from a series to the closed form.
- The samples are drawn with a fixed seed, and lengths are spread evenly over the powers of two. Sine and cosine are those of
  the C library, within one ulp. The arc tangent is the library's own, within two and a half.

Some functions are left out because they have no rounding of their own: the doors that only check, `inverse` of rotations,
`aligned`, conversions that reorder numbers, `hat`, `ad`, sums and differences of two vectors. Graphs, snapshots and moving
transforms are compositions of the functions below; `SampledAttitude` is a slerp, and `GyroErrors` is a product with a matrix.
Others are left out although they round: covariances and `estimate_motion`, whose errors are those of noisy samples, and the
Earth. For integration see [validation.md](validation.md).
)";

}  // namespace vectrix::accuracy
