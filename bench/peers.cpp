/// The same tasks in Vectrix, raw Eigen, Simbody, KDL and tf2 on the same numbers, side by side:
///     peers <title>    prints the table of one build under that title
/// Fails if Vectrix's result differs from raw Eigen's. If another library's result differs, prints by how
/// much.
#include "peers.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t rounds = 1001;
constexpr double round_ns = 10'000.0;
constexpr double same =
    1e-12;  // numbers of order 1; methods for a logarithm or a quaternion round differently

const std::vector<std::pair<Task, const char*>> tasks{
    {Task::dcm_product, "DCM product"},
    {Task::dcm_on_vector, "DCM on a vector"},
    {Task::chain_on_vector, "five DCMs on a vector, as written"},
    {Task::rate_chain, "angular velocities, chain of five"},
    {Task::quaternion_product, "quaternion product"},
    {Task::transform_product, "transform product, SE(3)"},
    {Task::dcm_to_quaternion_below, "DCM to quaternion, 1.3 rad"},
    {Task::dcm_to_quaternion_above, "DCM to quaternion, 2.7 rad"},
    {Task::exp_to_quaternion, "exp to quaternion, 1.3 rad"},
    {Task::exp_to_quaternion_small, "exp to quaternion, 1.3e-6 rad"},
    {Task::exp_to_dcm, "exp to DCM, 1.3 rad"},
    {Task::log_of_dcm, "log of a DCM, 1.3 rad"},
    {Task::log_of_dcm_small, "log of a DCM, 1e-7 rad"},
    {Task::log_of_quaternion, "log of a quaternion, 1.3 rad"},
    {Task::log_of_quaternion_small, "log of a quaternion, 1.3e-6 rad"},
    {Task::quaternion_to_dcm, "quaternion to DCM"},
    {Task::euler_to_dcm, "yaw, pitch and roll to DCM"},
    {Task::dcm_to_euler, "DCM to yaw, pitch and roll"}};

Four unit(const Four& q) {
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
}

Nine rows(const Four& quaternion) {
  const auto [w, x, y, z] = quaternion;
  return {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z),       2.0 * (x * z + w * y),
          2.0 * (x * y + w * z),       1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x),
          2.0 * (x * z - w * y),       2.0 * (y * z + w * x),       1.0 - 2.0 * (x * x + y * y)};
}

Given given() {
  const Three axis{0.48, -0.6, 0.64};
  const auto along_axis = [&](double angle) {
    return Three{angle * axis[0], angle * axis[1], angle * axis[2]};
  };
  const auto quaternion = [&](double angle) {
    const auto [x, y, z] = along_axis(std::sin(angle / 2.0));
    return Four{std::cos(angle / 2.0), x, y, z};
  };
  const auto turned = [&](double angle) { return rows(quaternion(angle)); };
  const std::array<Four, 5> q{unit({-0.1, 0.9, 0.3, 0.2}), unit({0.4, -0.2, 0.5, 0.7}),
                              unit({0.5, 0.1, -0.8, 0.3}), unit({0.2, -0.6, -0.3, 0.7}),
                              unit({-0.7, 0.3, 0.4, -0.5})};
  return {{rows(q[0]), rows(q[1]), rows(q[2]), rows(q[3]), rows(q[4])},
          {{{0.3, -1.1, 0.7}, {-0.2, 0.4, 0.9}, {0.8, 0.1, -0.6}, {-0.5, -0.3, 0.2}, {0.6, 1.2, -0.4}}},
          {q[0], q[1]},
          {{{1.3, -0.4, 0.2}, {-0.7, 0.9, 1.1}}},
          {0.2, -0.5, 1.4},
          along_axis(1.3),
          along_axis(1.3e-6),
          turned(1.3),
          turned(2.7),
          turned(1e-7),
          quaternion(1.3),
          quaternion(1.3e-6),
          {0.7, -0.5, 1.1}};
}

/// The largest difference, infinite for NaN; q and -q are the same rotation.
double difference(const Numbers& one, const Numbers& other) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto largest = [&](double sign) {
    double found = one.size() == other.size() ? 0.0 : infinity;
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
      const double entry = std::abs(one[i] - sign * other[i]);
      if (!(entry <= found)) found = std::isfinite(entry) ? entry : infinity;
    }
    return found;
  };
  return one.size() == 4 ? std::min(largest(1.0), largest(-1.0)) : largest(1.0);
}

/// One batch, with its stack `down` bytes lower: the address of a result can double the time of equal code.
[[gnu::noinline]] double nanoseconds(const Way& way, long calls, std::size_t down) {
  keep(*static_cast<char*>(__builtin_alloca(down)));
  const auto start = Clock::now();
  way.repeat(calls);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / static_cast<double>(calls);
}

/// Rounds of one batch of each library in random order, so that a slow machine slows all.
std::vector<std::vector<double>> measure(const std::vector<const Way*>& ways) {
  std::mt19937 generator(20240229);
  std::vector<std::vector<double>> ns(ways.size());
  std::vector<long> calls;
  std::vector<std::size_t> order;
  for (const Way* way : ways) {
    constexpr long probe = 1000;
    nanoseconds(*way, probe, 64);
    calls.push_back(1 + static_cast<long>(round_ns / nanoseconds(*way, probe, 64)));
    order.push_back(order.size());
  }
  for (std::size_t round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), generator);
    const std::size_t down = 64 * (1 + generator() % 64);
    for (const std::size_t i : order) ns[i].push_back(nanoseconds(*ways[i], calls[i], down));
  }
  return ns;
}

bool run(const char* title) {
  const Given numbers = given();
  const std::vector<std::pair<const char*, Peer>> peers{{"Vectrix", vectrix_peer(numbers)},
                                                        {"raw Eigen", eigen_peer(numbers)},
                                                        {"Simbody", simbody_peer(numbers)},
                                                        {"KDL", kdl_peer(numbers)},
                                                        {"tf2", tf2_peer(numbers)}};
  std::string head = "| " + std::string(title), rule = "| ---";
  for (const auto& [name, peer] : peers) {
    head += " | " + std::string(name);
    rule += " | ---";
  }
  std::printf("%s |\n%s |\n", head.c_str(), rule.c_str());
  bool agree = true;
  for (const auto& [task, name] : tasks) {
    const Numbers expected = peers[1].second.at(task).result();
    std::vector<const Way*> ways;
    std::map<std::string, double> errors;
    for (const auto& [library, peer] : peers) {
      const auto found = peer.find(task);
      if (found == peer.end()) continue;
      ways.push_back(&found->second);
      errors[library] = difference(found->second.result(), expected);
    }
    if (!(errors.at(peers[0].first) <= same)) {
      std::fprintf(stderr, "peers: %s: %s and raw Eigen differ by %g\n", name, peers[0].first,
                   errors.at(peers[0].first));
      agree = false;
    }
    const auto ns = measure(ways);
    std::printf("| %s | %.1f", name, median(ns[0]));
    std::size_t measured = 1;
    for (std::size_t i = 1; i < peers.size(); ++i) {
      if (peers[i].second.count(task) == 0) {
        std::printf(" | -");
        continue;
      }
      std::vector<double> ratios(rounds);
      std::transform(ns[measured].begin(), ns[measured].end(), ns[0].begin(), ratios.begin(),
                     std::divides<>());
      std::printf(" | %.1f (%.2f)", median(ns[measured]), median(ratios));
      if (const double error = errors.at(peers[i].first); !(error <= same))
        std::printf(", off by %.0e", error);
      ++measured;
    }
    std::printf(" |\n");
  }
  std::printf("\n");
  return agree;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "peers <title>\n");
    return 2;
  }
  return bench::run(argv[1]) ? 0 : 1;
}
