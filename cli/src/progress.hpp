#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace vectrix::cli {

/// "orbit: 45 % of 100000, 12000 a second, 4 s left"
std::string progress_text(const std::string& what, std::size_t done, std::size_t total, double seconds);

/// One line on a terminal that says how far long work is. Nothing is written in the first half second, and
/// nothing at all if there is no terminal.
class Progress {
 public:
  explicit Progress(std::ostream* terminal) : terminal_(terminal) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { end(); }

  void begin(const std::string& what, std::size_t total);
  void count();
  /// Removes the line.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  std::ostream* terminal_;
  std::string what_{};
  std::size_t total_ = 0, done_ = 0;
  Clock::time_point started_{}, written_{};
  bool is_written_ = false;
};

}  // namespace vectrix::cli
