#pragma once

#include <random>
#include <vectrix/kinematics/named/graph.hpp>

#include "points/moving_points.hpp"

namespace vectrix_test {

/// A random tree of frames at one instant, and the reference: R and r of each frame as frame 0 sees them, by
/// products of differentiable matrices.
struct RandomTree {
  using Matrix = Eigen::Matrix<Dual2, 3, 3>;
  using Column = Eigen::Matrix<Dual2, 3, 1>;
  // The frames of the tree in the types that the edges are made of.
  using Placed = vectrix::Transform<Gcrf, Body, Dual2>;

  vectrix::NamedGraph graph;
  std::vector<vectrix::NamedFrame> frames;
  std::vector<Matrix> R_0_from;
  std::vector<Column> r_0;

  /// `add(graph, a, b, X_b^a)` adds the edge. Edges come in random order and random direction.
  template <class Add> explicit RandomTree(std::size_t most_frames, const Add& add) {
    using namespace vectrix;
    std::mt19937_64 generator(*rc::gen::arbitrary<std::uint64_t>());
    const auto below = [&](std::size_t n) {
      return std::uniform_int_distribution<std::size_t>(0, n - 1)(generator);
    };
    const std::size_t count = 2 + below(most_frames - 1);
    const Dual2 t = instant(std::uniform_real_distribution(-1.0, 1.0)(generator));
    struct Link {
      std::size_t a, b;
      Matrix R_a_from_b;
      Column r_ab_a;
    };
    std::vector<Link> links;
    R_0_from.push_back(constant(1.0) * Matrix::Identity());
    r_0.push_back(constant(0.0) * Column::Ones());
    for (std::size_t i = 0; i < count; ++i) {
      frames.push_back(graph.add_frame("frame " + std::to_string(i), FrameMotion::moving));
      if (i == 0) continue;
      const std::size_t parent = below(i);
      const auto X = travelling<Gcrf, Body>(std::uniform_real_distribution(-2.0, 2.0)(generator), t);
      const Matrix R = X.rotation.matrix();
      const Column r = X.translation.coordinates();
      R_0_from.push_back(R_0_from[parent] * R);
      r_0.push_back(r_0[parent] + R_0_from[parent] * r);
      if (below(2) == 0) {
        links.push_back({parent, i, R, r});
      } else {
        links.push_back({i, parent, R.transpose(), -(R.transpose() * r)});
      }
    }
    std::shuffle(links.begin(), links.end(), generator);
    for (const Link& link : links)
      add(graph, frames[link.a], frames[link.b],
          Placed{trust_dcm(to<Gcrf>, from<Body>, link.R_a_from_b),
                 displacement(of<Body>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, link.r_ab_a))});
  }

  /// Motion of frame j as frame i sees it.
  Motion<Gcrf, Body> motion(std::size_t i, std::size_t j) const {
    return Motion<Gcrf, Body>(vectrix::trust_dcm(vectrix::to<Gcrf>, vectrix::from<Body>,
                                                 Matrix(R_0_from[i].transpose() * R_0_from[j])));
  }
  /// r_pq, v_pq|a and a_pq|a, expressed in a.
  Track<Gcrf, Body, Gcrf> track(std::size_t p, std::size_t q, std::size_t a) const {
    using namespace vectrix;
    const Column r_pq_a = R_0_from[a].transpose() * (r_0[q] - r_0[p]);
    return Track<Gcrf, Body, Gcrf>(
        displacement(of<Body>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r_pq_a)));
  }

  Eigen::Matrix3d rotation(std::size_t i, std::size_t j) const {
    const auto value = [](const Dual2& x) { return vectrix_test::value(x); };
    return R_0_from[i].unaryExpr(value).transpose() * R_0_from[j].unaryExpr(value);
  }

  template <class Check> void for_all(const Check& check) const {
    for (std::size_t i = 0; i < frames.size(); ++i)
      for (std::size_t j = 0; j < frames.size(); ++j) check(i, j);
  }
};

}  // namespace vectrix_test
