#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <random>
#include <thread>
#include <vectrix/kinematics/named/graph.hpp>

#include "testing/trials.hpp"

using namespace vectrix;

// Also built with the thread sanitizer: see kinematics/CMakeLists.txt.
namespace graph_threads_test {
namespace {

constexpr std::size_t frame_count = 60;
constexpr int readers = 4;
constexpr int rounds = 8;
/// Up to sixty products of rotations, with three roundings each.
constexpr double rounding = 256 * std::numeric_limits<double>::epsilon();

/// A tree that is built edge by edge in random order, with the correct answers at each step.
struct Plan {
  struct Link {
    std::size_t a, b;
  };
  std::vector<Eigen::Matrix3d> attitude;  // of each frame, in the same axes
  std::vector<Link> links;
  /// The number of edges after which two frames are joined.
  std::vector<std::vector<std::size_t>> joined_after;

  explicit Plan(std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < frame_count; ++i) {
      Eigen::Vector4d q;
      for (double& x : q) x = normal(generator);
      attitude.push_back(Eigen::Quaterniond(q.normalized()).toRotationMatrix());
      if (i > 0) links.push_back({i, std::uniform_int_distribution<std::size_t>(0, i - 1)(generator)});
    }
    std::shuffle(links.begin(), links.end(), generator);
    joined_after.assign(frame_count, std::vector<std::size_t>(frame_count, links.size() + 1));
    std::vector<std::size_t> tree(frame_count);
    std::iota(tree.begin(), tree.end(), std::size_t{0});
    for (std::size_t i = 0; i < frame_count; ++i) joined_after[i][i] = 0;
    for (std::size_t k = 0; k < links.size(); ++k) {
      const std::size_t kept = tree[links[k].a], merged = tree[links[k].b];
      for (std::size_t i = 0; i < frame_count; ++i)
        for (std::size_t j = 0; j < frame_count; ++j)
          if (tree[i] == kept && tree[j] == merged) joined_after[i][j] = joined_after[j][i] = k + 1;
      std::replace(tree.begin(), tree.end(), merged, kept);
    }
  }
  Eigen::Matrix3d rotation(std::size_t to, std::size_t from) const {
    return attitude[to].transpose() * attitude[from];
  }
};

std::string name(std::size_t i) {
  return "frame " + std::to_string(i);
}

/// Shared by the threads of a round. Progress is recorded before and after each edge.
struct Round {
  explicit Round(const Plan& planned, std::size_t cached_paths) : plan(planned), graph(cached_paths) {}

  const Plan& plan;
  NamedGraph graph;
  std::vector<NamedFrame> frames;
  std::atomic<std::size_t> begun{0}, done{0};
  std::atomic<int> wrong{0}, answers{0};

  void write() {
    for (const Plan::Link& link : plan.links) {
      begun.fetch_add(1);
      const NamedFrame a = frames[link.a], b = frames[link.b];
      const NamedDcm R = trust_dcm(To(a), From(b), plan.rotation(link.a, link.b));
      if (link.a % 2 == 0) {
        graph.add_edge(rigid_edge(R));
      } else {
        graph.add_edge(edge(To(a), From(b), [R](Quantity<si::time>) { return R; }));
      }
      done.fetch_add(1);
      std::this_thread::yield();
    }
  }

  // Adds frames and edges of another tree, with names that make the index grow.
  void write_elsewhere() {
    NamedFrame before = graph.add_frame("elsewhere", FrameMotion::moving);
    for (int i = 0; i < 300; ++i) {
      const NamedFrame next = graph.add_frame("elsewhere " + std::to_string(i), FrameMotion::moving);
      graph.add_edge(static_edge(aligned(To(before), From(next))));
      before = next;
    }
  }

  void read(std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::uniform_int_distribution<std::size_t> any(0, frame_count - 1);
    for (std::size_t after_all = 0; after_all < 200;) {
      if (done == plan.links.size()) ++after_all;
      const std::size_t i = any(generator), j = any(generator);
      const std::size_t done_before = done;
      bool answered = true;
      try {
        const NamedSnapshot now = graph.at(0.0 * si::second);
        const NamedDcm R = i % 2 == 0 ? now.rotation(To(name(i)), From(name(j)))
                                      : graph.at(0.0 * si::second).rotation(To(frames[i]), From(frames[j]));
        if (!((R.matrix() - plan.rotation(i, j)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= rounding))
          ++wrong;
        ++answers;
      } catch (const BadInput&) {
        answered = false;
      }
      // If there is an answer, its edges must have been begun; if there is a refusal, an edge must have been
      // missing before the query.
      if (answered ? plan.joined_after[i][j] > begun : plan.joined_after[i][j] <= done_before) ++wrong;
    }
  }
};

TEST(NamedGraphThreads, AnswersAreRightWhileEdgesAreAdded) {
  std::mt19937_64 generator(20240229);
  for (int round = 0; round < rounds; ++round) {
    const Plan plan(generator);
    Round shared(plan, round % 2 == 0 ? 64 : 1024);  // with a cache that fills up, and with one that does not
    for (std::size_t i = 0; i < frame_count; ++i)
      shared.frames.push_back(shared.graph.add_frame(name(i), FrameMotion::moving));
    std::vector<std::thread> threads;
    for (std::uint64_t reader = 0; reader < readers; ++reader)
      threads.emplace_back([&, seed = generator()] { shared.read(seed); });
    threads.emplace_back([&] { shared.write(); });
    threads.emplace_back([&] { shared.write_elsewhere(); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(shared.wrong, 0);
    EXPECT_GT(shared.answers, 0);
  }
}

// While a tree gets a new root, a reader sees old and new positions of its frames in the tree together. Its
// paths must still be correct.
TEST(NamedGraphThreads, PathsHoldWhileTheirTreeIsJoinedToALargerOne) {
  constexpr int joinings = vectrix_test::trials(10);
  constexpr int leaves =
      20'000;  // joining takes milliseconds, so that a query runs meanwhile even on one processor
  for (int joining = 0; joining < joinings; ++joining) {
    NamedGraph graph(0);  // paths are not cached: each is searched again
    std::vector<NamedFrame> star;
    const auto add_star = [&](const std::string& prefix, int count) {
      star = {graph.add_frame(prefix, FrameMotion::moving)};
      for (int i = 0; i < count; ++i) {
        star.push_back(graph.add_frame(prefix + std::to_string(i), FrameMotion::moving));
        graph.add_edge(static_edge(turned_z(To(star.front()), From(star.back()), 1e-4 * i * si::radian)));
      }
      return star.front();
    };
    const NamedFrame larger = add_star("larger ", leaves + 1);
    const NamedFrame smaller = add_star("smaller ", leaves);
    std::atomic<bool> joined{false};
    std::atomic<int> asked{0}, refused{0}, wrong{0};
    const Eigen::Matrix3d expected =
        Eigen::AngleAxisd(-1e-4 * (leaves - 1), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    std::thread reader([&] {
      while (!joined) {
        try {
          const NamedDcm R = graph.at(0.0 * si::second).rotation(To(star[1]), From(star.back()));
          if (!(R.matrix() - expected).isZero(rounding)) ++wrong;
        } catch (const BadInput&) {
          ++refused;
        }
        ++asked;
      }
    });
    while (asked == 0) std::this_thread::yield();
    graph.add_edge(static_edge(aligned(To(larger), From(smaller))));
    joined = true;
    reader.join();
    ASSERT_EQ(refused, 0);
    ASSERT_EQ(wrong, 0);
  }
}

// Threads query one sampled edge and one function edge at the same time.
TEST(NamedGraphThreads, EdgesAreReadByManyThreads) {
  NamedGraph graph;
  const NamedFrame a = graph.add_frame("a", FrameMotion::inertial);
  const NamedFrame b = graph.add_frame("b", FrameMotion::moving);
  const NamedFrame c = graph.add_frame("c", FrameMotion::moving);
  std::vector<NamedSample> samples;
  for (int i = 0; i <= 100; ++i) {
    const NamedDcm R = turned_z(To(a), From(b), -0.1 * i * si::radian);
    samples.push_back({0.5 * i * si::second, quaternion(R)});
  }
  graph.add_edge(sampled_edge(samples, 1.0 * si::second));
  graph.add_edge(edge(To(b), From(c), [=](Quantity<si::time> t) {
    return turned_z(To(b), From(c), Quantity<si::angle>::from_value(0.2 * t.value()));
  }));
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int reader = 0; reader < readers; ++reader) {
    threads.emplace_back([&, reader] {
      for (int i = 0; i < 2000; ++i) {
        const auto t = 0.0123 * (i + reader) * si::second;
        const auto R = graph.at(t).rotation(To("a"), From(c));  // the two turns cancel
        if (!((R.matrix() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <=
              rounding))
          ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace graph_threads_test
