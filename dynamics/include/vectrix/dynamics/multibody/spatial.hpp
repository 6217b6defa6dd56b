#pragma once

/// Columns and 3x3 matrices of plain numbers, all in one set of axes. No name of a frame occurs here: what
/// has frames in its types becomes these numbers once, when a craft is made.
namespace vectrix::multibody {

/// Copied number by number, in the width in which each is read again: the compiler's copy of a whole has
/// another width, and a load that needs two stores makes the processor wait.
template <class S> struct Column {
  S x, y, z;

  Column() = default;
  [[gnu::always_inline]] Column(const S& x_, const S& y_, const S& z_) : x(x_), y(y_), z(z_) {}
  [[gnu::always_inline]] Column(const Column& b) : x(b.x), y(b.y), z(b.z) {}
  [[gnu::always_inline]] Column& operator=(const Column& b) {
    x = b.x, y = b.y, z = b.z;
    return *this;
  }
  [[gnu::always_inline]] Column& operator+=(const Column& b) {
    x += b.x, y += b.y, z += b.z;
    return *this;
  }
  [[gnu::always_inline]] Column& operator-=(const Column& b) {
    x -= b.x, y -= b.y, z -= b.z;
    return *this;
  }
  [[gnu::always_inline]] Column operator-() const { return {S(-x), S(-y), S(-z)}; }
  [[gnu::always_inline]] friend Column operator+(const Column& a, const Column& b) {
    return {S(a.x + b.x), S(a.y + b.y), S(a.z + b.z)};
  }
  [[gnu::always_inline]] friend Column operator-(const Column& a, const Column& b) {
    return {S(a.x - b.x), S(a.y - b.y), S(a.z - b.z)};
  }
  [[gnu::always_inline]] friend Column operator*(const Column& a, const S& k) {
    return {S(a.x * k), S(a.y * k), S(a.z * k)};
  }
};

template <class S> Column<S> zero_column() {
  return {S(0.0), S(0.0), S(0.0)};
}

template <class S> [[gnu::always_inline]] inline S dot(const Column<S>& a, const Column<S>& b) {
  return S(a.x * b.x + a.y * b.y + a.z * b.z);
}
template <class S> [[gnu::always_inline]] inline Column<S> cross(const Column<S>& a, const Column<S>& b) {
  return {S(a.y * b.z - a.z * b.y), S(a.z * b.x - a.x * b.z), S(a.x * b.y - a.y * b.x)};
}

/// A 3x3 matrix by its columns.
template <class S> struct Square {
  Column<S> x, y, z;

  [[gnu::always_inline]] friend Column<S> operator*(const Square& m, const Column<S>& v) {
    return {S(m.x.x * v.x + m.y.x * v.y + m.z.x * v.z), S(m.x.y * v.x + m.y.y * v.y + m.z.y * v.z),
            S(m.x.z * v.x + m.y.z * v.y + m.z.z * v.z)};
  }
  [[gnu::always_inline]] friend Square operator*(const Square& a, const Square& b) {
    return {a * b.x, a * b.y, a * b.z};
  }
};

/// m^T v
template <class S>
[[gnu::always_inline]] inline Column<S> transposed_times(const Square<S>& m, const Column<S>& v) {
  return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

template <class S> Square<S> identity() {
  const S one(1.0), none(0.0);
  return {{one, none, none}, {none, one, none}, {none, none, one}};
}

/// [c]x
template <class S> [[gnu::always_inline]] inline Square<S> hat(const Column<S>& c) {
  return {{S(0.0), c.z, S(-c.y)}, {S(-c.z), S(0.0), c.x}, {c.y, S(-c.x), S(0.0)}};
}

/// A symmetric 3x3 matrix by its six numbers.
template <class S> struct Symmetric {
  S xx, yy, zz, xy, xz, yz;

  Symmetric() = default;
  [[gnu::always_inline]] Symmetric(const S& xx_, const S& yy_, const S& zz_, const S& xy_, const S& xz_,
                                   const S& yz_)
      : xx(xx_), yy(yy_), zz(zz_), xy(xy_), xz(xz_), yz(yz_) {}
  [[gnu::always_inline]] Symmetric(const Symmetric& b)
      : xx(b.xx), yy(b.yy), zz(b.zz), xy(b.xy), xz(b.xz), yz(b.yz) {}
  [[gnu::always_inline]] Symmetric& operator=(const Symmetric& b) {
    xx = b.xx, yy = b.yy, zz = b.zz, xy = b.xy, xz = b.xz, yz = b.yz;
    return *this;
  }
  [[gnu::always_inline]] friend Column<S> operator*(const Symmetric& m, const Column<S>& v) {
    return {S(m.xx * v.x + m.xy * v.y + m.xz * v.z), S(m.xy * v.x + m.yy * v.y + m.yz * v.z),
            S(m.xz * v.x + m.yz * v.y + m.zz * v.z)};
  }
  [[gnu::always_inline]] friend Square<S> operator*(const Symmetric& m, const Square<S>& a) {
    return {m * a.x, m * a.y, m * a.z};
  }
  [[gnu::always_inline]] Symmetric& operator+=(const Symmetric& b) {
    xx += b.xx, yy += b.yy, zz += b.zz, xy += b.xy, xz += b.xz, yz += b.yz;
    return *this;
  }
  /// this -= u v^T, for parallel u and v.
  [[gnu::always_inline]] void subtract_outer(const Column<S>& u, const Column<S>& v) {
    xx -= u.x * v.x, yy -= u.y * v.y, zz -= u.z * v.z;
    xy -= u.x * v.y, xz -= u.x * v.z, yz -= u.y * v.z;
  }
};

template <class S> [[gnu::always_inline]] inline Symmetric<S> diagonal(const S& m) {
  return {m, m, m, S(0.0), S(0.0), S(0.0)};
}

template <class S> [[gnu::always_inline]] inline Symmetric<S> inverse(const Symmetric<S>& m) {
  const S xx(m.yy * m.zz - m.yz * m.yz), xy(m.xz * m.yz - m.xy * m.zz), xz(m.xy * m.yz - m.xz * m.yy);
  const S k(S(1.0) / (m.xx * xx + m.xy * xy + m.xz * xz));
  return {S(k * xx), S(k * (m.xx * m.zz - m.xz * m.xz)), S(k * (m.xx * m.yy - m.xy * m.xy)), S(k * xy),
          S(k * xz), S(k * (m.xy * m.xz - m.xx * m.yz))};
}

/// The six numbers of a b^T, which is symmetric.
template <class S>
[[gnu::always_inline]] inline Symmetric<S> times_transposed(const Square<S>& a, const Square<S>& b) {
  return {S(a.x.x * b.x.x + a.y.x * b.y.x + a.z.x * b.z.x), S(a.x.y * b.x.y + a.y.y * b.y.y + a.z.y * b.z.y),
          S(a.x.z * b.x.z + a.y.z * b.y.z + a.z.z * b.z.z), S(a.x.x * b.x.y + a.y.x * b.y.y + a.z.x * b.z.y),
          S(a.x.x * b.x.z + a.y.x * b.y.z + a.z.x * b.z.z), S(a.x.y * b.x.z + a.y.y * b.y.z + a.z.y * b.z.z)};
}

/// a m, by columns.
template <class S>
[[gnu::always_inline]] inline Square<S> product(const Square<S>& a, const Symmetric<S>& m) {
  return {a * Column<S>{m.xx, m.xy, m.xz}, a * Column<S>{m.xy, m.yy, m.yz}, a * Column<S>{m.xz, m.yz, m.zz}};
}

/// R m R^T
template <class S>
[[gnu::always_inline]] inline Symmetric<S> rotated(const Square<S>& R, const Symmetric<S>& m) {
  return times_transposed(product(R, m), R);
}

/// R_b^a of the four numbers q_b^a, scalar first, of any norm: integrated numbers are never projected.
template <class S> [[gnu::always_inline]] inline Square<S> matrix_of_quaternion(const S* q) {
  const S s(S(2.0) / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]));
  const S x(q[1] * s), y(q[2] * s), z(q[3] * s);
  const S wx(q[0] * x), wy(q[0] * y), wz(q[0] * z);
  const S xx(q[1] * x), xy(q[1] * y), xz(q[1] * z), yy(q[2] * y), yz(q[2] * z), zz(q[3] * z);
  const S one(1.0);
  return {{S(one - (yy + zz)), S(xy + wz), S(xz - wy)},
          {S(xy - wz), S(one - (xx + zz)), S(yz + wx)},
          {S(xz + wy), S(yz - wx), S(one - (xx + yy))}};
}

/// q' = 1/2 q (0, w), w in the frame that turns.
template <class S> [[gnu::always_inline]] inline void quaternion_rate(const S* q, const S* w, S* qdot) {
  const S half(0.5);
  qdot[0] = -half * (q[1] * w[0] + q[2] * w[1] + q[3] * w[2]);
  qdot[1] = half * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]);
  qdot[2] = half * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]);
  qdot[3] = half * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
}

}  // namespace vectrix::multibody
