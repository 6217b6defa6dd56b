/// Look-ups in a graph of frames known at run time, over a path of six edges, compared with tf2 in the same
/// run. Prints a section of docs/evidence/performance.md. Fails if the two libraries disagree.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/kinematics/named/graph.hpp>

#include "tf2_reference.hpp"
#include "timing.hpp"

namespace bench {
namespace {

using namespace vectrix;
using Clock = std::chrono::steady_clock;

constexpr std::size_t depth = 6;
constexpr std::size_t samples = 16;
constexpr double step = 0.05;  // s, from one sample to the next
constexpr double start = 100.0;
constexpr double turn = 0.2;  // rad, from one sample to the next
// Both compute rotations of order 1; tf2 uses quaternions throughout. The time of tf2 is in whole
// nanoseconds, during which the edges turn by less than 1e-8 rad.
constexpr double same = 1e-7;

std::string name(std::size_t i) {
  return i == 0 ? "base_link" : "frame_" + std::to_string(i);
}

Eigen::Quaterniond random_attitude(std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  const auto next = [&] { return normal(generator); };
  const double w = next(), x = next(), y = next(), z = next();
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

/// The attitudes of each edge, one after the other in time.
std::vector<std::vector<Eigen::Quaterniond>> attitudes() {
  std::mt19937_64 generator(20240229);
  std::vector<std::vector<Eigen::Quaterniond>> list(depth);
  for (auto& edge : list) {
    edge.push_back(random_attitude(generator));
    const auto axis = random_attitude(generator).vec().normalized();
    for (std::size_t i = 1; i < samples; ++i)
      edge.push_back(edge.back() * Eigen::Quaterniond(Eigen::AngleAxisd(turn, axis)));
  }
  return list;
}

/// A chain of frames: `make(to, from, i)` gives the i-th edge.
struct Chain {
  NamedGraph graph;
  std::vector<NamedFrame> frames;

  template <class Make>
  explicit Chain(const Make& make, std::size_t cached_paths = 1024) : graph(cached_paths) {
    for (std::size_t i = 0; i <= depth; ++i) frames.push_back(graph.add_frame(name(i), FrameMotion::moving));
    for (std::size_t i = 0; i < depth; ++i) graph.add_edge(make(frames[i], frames[i + 1], i));
  }
};

NamedEdge interpolated(const std::vector<Eigen::Quaterniond>& attitudes, NamedFrame a, NamedFrame b) {
  std::vector<NamedSample> list;
  for (std::size_t i = 0; i < attitudes.size(); ++i) {
    const auto& q = attitudes[i];
    list.push_back({(start + static_cast<double>(i) * step) * si::second,
                    quaternion_scalar_first(To(a), From(b), q.w(), q.x(), q.y(), q.z())});
  }
  return sampled_edge(list, 1.0 * si::second);
}

void fill(Tf2Reference& buffer, const std::vector<std::vector<Eigen::Quaterniond>>& attitudes, bool fixed) {
  for (std::size_t i = 0; i < depth; ++i) {
    for (std::size_t k = 0; k < (fixed ? 1 : samples); ++k) {
      const auto& q = attitudes[i][k];
      buffer.add(name(i), name(i + 1), start + static_cast<double>(k) * step, {q.w(), q.x(), q.y(), q.z()},
                 fixed);
    }
  }
}

struct Row {
  const char* edges;
  const char* what;
  std::function<void(double)> look_up;
  std::vector<double> ns = {};
};

/// Interleaved rounds, so that a slow machine slows all.
void measure(std::vector<Row>& rows) {
  constexpr int rounds = 301, calls = 200;
  std::mt19937_64 generator(7);
  std::vector<double> times(calls);
  for (double& t : times) t = std::uniform_real_distribution(start, start + (samples - 1) * step)(generator);
  std::vector<Row*> order;
  for (Row& row : rows) order.push_back(&row);
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), generator);
    for (Row* row : order) {
      const auto begin = Clock::now();
      for (const double t : times) row->look_up(t);
      row->ns.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / calls);
    }
  }
  for (Row& row : rows) std::nth_element(row.ns.begin(), row.ns.begin() + rounds / 2, row.ns.end());
}

bool agree(const NamedGraph& graph, const Tf2Reference& buffer) {
  double largest = 0.0;
  for (double t = start; t < start + (samples - 1) * step; t += 0.037) {
    const auto R = graph.at(t * si::second).rotation(To(name(0)), From(name(depth))).matrix();
    const auto [w, x, y, z] = buffer.look_up(name(0), name(depth), t);
    const Eigen::Matrix3d error = R - Eigen::Quaterniond(w, x, y, z).toRotationMatrix();
    largest = vectrix::detail::larger(largest, error.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  if (largest <= same) return true;
  std::fprintf(stderr, "named_graph: Vectrix and tf2 differ by %g\n", largest);
  return false;
}

int run() {
  const auto list = attitudes();
  const auto fixed = [&](NamedFrame a, NamedFrame b, std::size_t i) {
    return static_edge(trust_dcm(To(a), From(b), list[i][0].toRotationMatrix()));
  };
  const Chain fixed_chain(fixed);
  const Chain uncached_chain(fixed, 0);
  const Chain sampled_chain(
      [&](NamedFrame a, NamedFrame b, std::size_t i) { return interpolated(list[i], a, b); });
  const Chain function_chain([&](NamedFrame a, NamedFrame b, std::size_t i) {
    const double rate = 0.1 * static_cast<double>(i + 1);
    return edge(To(a), From(b), [=](Quantity<si::time> t) {
      return turned_z(To(a), From(b), Quantity<si::angle>::from_value(rate * t.value()));
    });
  });
  Tf2Reference fixed_buffer, sampled_buffer;
  fill(fixed_buffer, list, true);
  fill(sampled_buffer, list, false);
  if (!agree(fixed_chain.graph, fixed_buffer) || !agree(sampled_chain.graph, sampled_buffer)) return 1;

  const std::string first = name(0), last = name(depth);
  const auto by_handle = [](const Chain& chain) {
    return [&](double t) {
      keep(chain.graph.at(t * si::second).rotation(To(chain.frames.front()), From(chain.frames.back())));
    };
  };
  const auto by_name = [&](const Chain& chain) {
    return [&](double t) { keep(chain.graph.at(t * si::second).rotation(To(first), From(last))); };
  };
  const auto by_tf2 = [&](const Tf2Reference& buffer) {
    return [&](double t) { keep(buffer.look_up(first, last, t)); };
  };
  const auto rate = [](const Chain& chain) {
    return [&](double t) {
      const NamedFrame a = chain.frames.front(), b = chain.frames.back();
      keep(chain.graph.at(t * si::second).angular_velocity(Of(b), RelativeTo(a), In(b)));
    };
  };
  std::vector<Row> rows{{"fixed", "by handle", by_handle(fixed_chain)},
                        {"fixed", "by name", by_name(fixed_chain)},
                        {"fixed", "by handle, the path not in the cache", by_handle(uncached_chain)},
                        {"fixed", "tf2", by_tf2(fixed_buffer)},
                        {"interpolated", "by handle", by_handle(sampled_chain)},
                        {"interpolated", "by name", by_name(sampled_chain)},
                        {"interpolated", "by handle, angular velocity", rate(sampled_chain)},
                        {"interpolated", "tf2", by_tf2(sampled_buffer)},
                        {"functions, `turned_z`", "by handle", by_handle(function_chain)}};
  measure(rows);
  std::printf(
      "## Look-ups in the run-time graph\n\n"
      "A path of six edges, g++, x86-64, at random times, medians of "
      "interleaved rounds. Interpolated: %zu samples on each edge, %.1f rad from one to the next. tf2 "
      "searches its samples one after the other, so that few samples are an advantage for it. tf2 also "
      "looks up positions, and takes frames by name only. The product of fixed edges is stored with the "
      "path.\n\n"
      "| edges | look-up | ns |\n| --- | --- | --- |\n",
      samples, turn);
  for (const Row& row : rows)
    std::printf("| %s | %s | %.0f |\n", row.edges, row.what, row.ns[row.ns.size() / 2]);
  return 0;
}

}  // namespace
}  // namespace bench

int main() {
  return bench::run();
}
