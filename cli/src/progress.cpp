#include "progress.hpp"

#include <cmath>
#include <ostream>

namespace vectrix::cli {

std::string progress_text(const std::string& what, std::size_t done, std::size_t total, double seconds) {
  const double rate = static_cast<double>(done) / seconds;
  const auto whole = [](double number) { return std::to_string(std::llround(number)); };
  return what + ": " + std::to_string(100 * done / total) + " % of " + std::to_string(total) + ", " +
         whole(rate) + " a second, " + whole(std::ceil(static_cast<double>(total - done) / rate)) + " s left";
}

void Progress::begin(const std::string& what, std::size_t total) {
  end();
  what_ = what;
  total_ = total;
  done_ = 0;
  started_ = written_ = Clock::now();
}

void Progress::count() {
  ++done_;
  constexpr std::size_t often = 64;  // the clock is not asked at each
  if (!terminal_ || done_ % often != 0) return;
  const auto now = Clock::now();
  constexpr std::chrono::milliseconds between{500};
  if (now - written_ < between) return;
  written_ = now;
  is_written_ = true;
  *terminal_ << "\r\x1b[K"
             << progress_text(what_, done_, total_, std::chrono::duration<double>(now - started_).count())
             << std::flush;
}

void Progress::end() {
  if (is_written_) *terminal_ << "\r\x1b[K" << std::flush;
  is_written_ = false;
}

}  // namespace vectrix::cli
