/// Ephemeris messages of a million lines, read with all checks, compared in the same run with a loop that
/// takes the numbers of the same files with std::from_chars and checks nothing. Prints a section of
/// docs/evidence/performance.md. Fails if the last lines differ.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/space/files/attitude_ephemeris_message.hpp>
#include <vectrix/space/files/orbit_ephemeris_message.hpp>

#include "timing.hpp"

namespace bench {
namespace {

using namespace vectrix;

constexpr int lines_of_file = 1'000'000;

struct PlainLine {
  int year, month, day, hour, minute;
  double second;
  double numbers[6];
};

std::vector<PlainLine> read_plainly(const std::filesystem::path& file, std::string_view before, int numbers) {
  std::string all(std::filesystem::file_size(file), '\0');
  std::ifstream(file, std::ios::binary).read(all.data(), static_cast<std::streamsize>(all.size()));
  const char* at = all.data() + all.find(before) + before.size();
  const char* const end = all.data() + all.size();
  std::vector<PlainLine> lines;
  while (at < end && *at >= '0' && *at <= '9') {
    PlainLine line{};
    for (int* part : {&line.year, &line.month, &line.day, &line.hour, &line.minute})
      at = std::from_chars(at, end, *part).ptr + 1;
    at = std::from_chars(at, end, line.second).ptr;
    for (int i = 0; i < numbers; ++i) at = std::from_chars(at + 1, end, line.numbers[i]).ptr;
    ++at;
    lines.push_back(line);
  }
  return lines;
}

/// A temporary file.
struct Written {
  explicit Written(const std::string& name)
      : path(std::filesystem::temp_directory_path() / ("vectrix_bench_" + name)) {}
  Written(const Written&) = delete;
  ~Written() { std::filesystem::remove(path); }
  std::filesystem::path path;
};

std::string begin_of(const char* kind, const char* frames, const char* type) {
  return "CCSDS_" + std::string{kind} +
         "_VERS = 2.0\nCREATION_DATE = 2026-11-29T00:00:00\nORIGINATOR = BENCH\nMETA_START\nOBJECT_NAME = "
         "SATELLITE\nOBJECT_ID = 2026-001A\n" +
         frames + "TIME_SYSTEM = UTC\nSTART_TIME = 2020-01-01T00:00:00\nSTOP_TIME = 2021-01-01T00:00:00\n" +
         type + "META_STOP\n";
}

/// The message with so many numbers in a line, each in this format.
void write_message(const Written& file, std::string text, int numbers, const char* format, const char* end) {
  std::mt19937_64 random(20261129);
  std::normal_distribution<double> normal;
  const Epoch start = Epoch::from_utc("2020-01-01T00:00:00");
  for (int line = 0; line < lines_of_file; ++line) {
    text += (start + 10.0 * line * si::second).utc(3);
    double x[6], sum = 0.0;
    for (double& each : x) {
      each = normal(random);
      if (&each < x + numbers) sum += each * each;
    }
    for (int i = 0; i < numbers; ++i) {
      char number[32];
      const double scale = numbers == 4 ? 1.0 / std::sqrt(sum) : i < 3 ? 7000.0 : 7.5;
      std::snprintf(number, sizeof number, format, scale * x[i]);
      text += number;
    }
    text += '\n';
  }
  std::ofstream(file.path, std::ios::binary) << text << end;
}

template <class Call> double seconds(const Call& call) {
  const auto begin = std::chrono::steady_clock::now();
  keep(call());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class Read>
void print_row(const char* name, const Read& read, const Written& file, std::string_view before,
               int numbers) {
  constexpr int rounds = 7;
  constexpr double target = 1.2;
  double ours = 1e9, theirs = 1e9;
  for (int round = 0; round < rounds; ++round) {
    ours = std::min(ours, seconds([&] { return read(file.path); }));
    theirs = std::min(theirs, seconds([&] { return read_plainly(file.path, before, numbers); }));
  }
  std::printf("| %s | %.3f | %.3f | %.2f | %.1f%s |\n", name, ours, theirs, ours / theirs, target,
              ours <= target * theirs ? "" : ", missed");
}

int run() {
  const std::string orbit = begin_of("OEM", "CENTER_NAME = EARTH\nREF_FRAME = GCRF\n", ""),
                    attitude = begin_of("AEM", "REF_FRAME_A = GCRF\nREF_FRAME_B = SC_BODY_1\n",
                                        "ATTITUDE_TYPE = QUATERNION\n") +
                               "DATA_START\n";
  const Written decimals("decimals.oem"), exponents("exponents.oem"), quaternions("quaternions.aem");
  write_message(decimals, orbit, 6, " %.12f", "");
  write_message(exponents, orbit, 6, " %.16e", "");
  write_message(quaternions, attitude, 4, " %.16f", "DATA_STOP\n");

  const auto oem = OrbitEphemerisMessage::read(exponents.path);
  const auto& last = oem.segments().front().lines(detail::trusted).lines.back();
  const PlainLine plain = read_plainly(exponents.path, "META_STOP\n", 6).back();
  if (oem.segments().front().size() != lines_of_file ||
      std::abs(last.velocity.z() - 1e3 * plain.numbers[5]) > 1e-9) {
    std::fprintf(stderr, "reading: the last lines differ\n");
    return 1;
  }
  std::printf(
      "## Reading ephemerides\n\n"
      "Files of a million lines, s. The plain loop reads the same file into memory, takes the numbers with "
      "std::from_chars, six of them the date, keeps them, and checks nothing. Vectrix makes epochs of the "
      "dates, "
      "checks their order and their span, counts lines and columns for its messages, and of quaternions it "
      "checks "
      "the norm. Least of interleaved runs.\n\n"
      "| file | Vectrix | plain loop | ratio | target |\n| --- | --- | --- | --- | --- |\n");
  const auto read_orbit = [](const auto& path) { return OrbitEphemerisMessage::read(path); };
  print_row("OEM, 12 decimals", read_orbit, decimals, "META_STOP\n", 6);
  print_row("OEM, 17 digits and an exponent", read_orbit, exponents, "META_STOP\n", 6);
  print_row(
      "AEM, quaternions of 16 decimals",
      [](const auto& path) { return AttitudeEphemerisMessage::read(path); }, quaternions, "DATA_START\n", 4);
  return 0;
}

}  // namespace
}  // namespace bench

int main() {
  return bench::run();
}
