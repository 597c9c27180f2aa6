#include "nearwall/core/helper_process.h"

#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>

#include <gtest/gtest.h>

namespace nearwall {
namespace {

constexpr std::chrono::seconds kLong{30};
constexpr std::chrono::milliseconds kShort{20};

TEST(HelperProcess, TellsHowItEndedAndWhatItSaid) {
  HelperProcess helper("/bin/sh", {"-c", "echo one >&2; echo two >&2; echo not told; exit 7"});
  ASSERT_TRUE(helper.has_started());
  ASSERT_TRUE(helper.wait(kLong));
  EXPECT_TRUE(WIFEXITED(helper.status()));
  EXPECT_EQ(WEXITSTATUS(helper.status()), 7);
  EXPECT_EQ(helper.talk(), "one\ntwo\n");
  EXPECT_EQ(helper.last_words(), "two");
}

TEST(HelperProcess, IsWaitedForNoLongerThanAsked) {
  HelperProcess helper("/bin/sh", {"-c", "exec sleep 60"});
  EXPECT_FALSE(helper.wait(kShort));
  EXPECT_EQ(::kill(helper.pid(), SIGTERM), 0);
  ASSERT_TRUE(helper.wait(kLong));
  EXPECT_TRUE(WIFSIGNALED(helper.status()));
  EXPECT_EQ(WTERMSIG(helper.status()), SIGTERM);
}

TEST(HelperProcess, IsKilledWhenItIsLeft) {
  int pid = 0;
  {
    const HelperProcess helper("/bin/sh", {"-c", "exec sleep 60"});
    pid = helper.pid();
    EXPECT_EQ(::kill(pid, 0), 0);
  }
  EXPECT_EQ(::kill(pid, 0), -1);
}

TEST(HelperProcess, SaysThatAProgramCannotBeStarted) {
  EXPECT_FALSE(HelperProcess("/no/such/program", {}).has_started());
}

TEST(FindHelper, LooksAtTheEnvironmentFirst) {
  ::setenv("NEARWALL_TRIAL", "/bin/sh", 1);
  EXPECT_EQ(find_helper("nearwall-trial"), "/bin/sh");
  ::setenv("NEARWALL_TRIAL", "/no/such/program", 1);
  EXPECT_TRUE(find_helper("nearwall-trial").empty());
  ::unsetenv("NEARWALL_TRIAL");
}

}  // namespace
}  // namespace nearwall
