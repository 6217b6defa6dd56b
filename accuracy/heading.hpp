#pragma once

namespace vectrix::accuracy {

inline constexpr const char* heading = R"(# Accuracy

Written by `./dev validate`. The error of every function in double precision, against `long double` of 64 binary digits, which
takes the same double numbers exactly.

- **ulp**: an error e counts |e| / (2^-52 scale), |e| being the Euclidean norm of the difference of vectors or
  quaternions, and the Frobenius norm of that of matrices. A rounding to nearest is at most half an ulp. The *scale* is
  named in each row: 1 for rotations, the size of the exact result for most others, the sum of the sizes of the terms
  where they may cancel.
- **The input is the number that is given.** A matrix or a quaternion of doubles is off the rotations by its own
  rounding; what is expected of it is what the nearest rotation, or q/|q|, would give in exact arithmetic; in sums and products
  the given numbers count as they are. That rounding, as far as a function lets it through, is part of the error seen.
- **The same rotation has several numbers.** The sign of a quaternion does not count; at half a turn either axis is
  right. Where numbers are ill-conditioned, as Euler angles near gimbal lock, the row says *backward*: the error is the
  angle between the rotation given and that of the numbers found.
- **Two kinds of reference.** An *independent* formula, named above each table, for what is not algebra: exponentials,
  logarithms, Jacobians, angles, motions. For sums and products, *rounding alone*: the same formula in `long double`;
  that it is the right one is the business of the tests.
- **The promise** counts roundings, half an ulp each, as if all went to one side, times what the domain can make of one.
  A row fails beyond it. The test suite measures the same rows with fewer samples.
- The samples are drawn with a fixed seed, lengths evenly over the powers of two. Sine and cosine are those
  of the C library, within one ulp; the arc tangent is the library's own, within two and a half.

Left out, for they round nothing of their own: the doors that only check, `inverse` of rotations, `aligned`,
conversions that reorder numbers, `hat`, `ad`, sums and differences of two vectors. Graphs, snapshots and moving
transforms compose what is here; `SampledAttitude` is a slerp, `GyroErrors` a product with a matrix. Left out though
they round: covariances and `estimate_motion`, whose errors are those of noisy samples; the Earth. Integration is in
[validation.md](validation.md).
)";

}  // namespace vectrix::accuracy
