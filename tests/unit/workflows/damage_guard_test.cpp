#include "workflows/store/damage_guard.hpp"
#include <csignal>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

TEST(DamageGuard, TurnsACrashInsideIntoBadInput) {
  for (int const signal : {SIGSEGV, SIGBUS, SIGFPE})
    EXPECT_EXIT(
        {
          DamageGuard const guard("some.h5");
          raise(signal);
        },
        ::testing::ExitedWithCode(2), "cannot read 'some.h5': it is damaged");
}

TEST(DamageGuard, LeavesOtherCrashesWhatTheyAre) {
  EXPECT_EXIT(
      {
        { DamageGuard const guard("some.h5"); }
        raise(SIGSEGV);
        raise(SIGSEGV); // the first one gives the signal back
      },
      ::testing::KilledBySignal(SIGSEGV), "");
}

TEST(DamageGuard, NamesTheInnermostFile) {
  EXPECT_EXIT(
      {
        DamageGuard const outer("outer.h5");
        { DamageGuard const inner("inner.h5"); }
        raise(SIGSEGV);
      },
      ::testing::ExitedWithCode(2), "'outer.h5'");
}

} // namespace
} // namespace mesobridge::workflows
