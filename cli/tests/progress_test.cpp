#include "progress.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <thread>

#include "says.hpp"

namespace vectrix::cli::progress_test {
namespace {

TEST(Progress, SaysTheRateAndTheTimeLeft) {
  EXPECT_EQ(progress_text("orbit", 45000, 100000, 3.75), "orbit: 45 % of 100000, 12000 a second, 5 s left");
  EXPECT_EQ(progress_text("orbit", 100, 100, 1.0), "orbit: 100 % of 100, 100 a second, 0 s left");
}

TEST(Progress, IsOneLineThatIsRemoved) {
  std::ostringstream terminal;
  {
    Progress progress(&terminal);
    progress.begin("orbit", 1000);
    for (int i = 0; i < 200; ++i) progress.count();
    EXPECT_EQ(terminal.str(), "");  // it did not take half a second
    std::this_thread::sleep_for(std::chrono::milliseconds(510));
    for (int i = 0; i < 64; ++i) progress.count();
    EXPECT_TRUE(says(terminal.str(), "orbit: 25 % of 1000, "));
    EXPECT_EQ(terminal.str().find('\n'), std::string::npos);
  }
  EXPECT_TRUE(terminal.str().ends_with("\r\x1b[K"));
}

}  // namespace
}  // namespace vectrix::cli::progress_test
