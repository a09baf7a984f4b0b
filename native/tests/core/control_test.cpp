#include "core/control.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

TEST(Control, starts_at_zero_and_not_cancelled) {
    const Control control;
    EXPECT_FALSE(control.cancelled());
    EXPECT_EQ(control.fraction(), 0);
    EXPECT_EQ(control.stage(), "");
    EXPECT_NO_THROW(control.check_cancel());
}

TEST(Control, cancel_stops_checks_and_stages) {
    Control control;
    control.cancel();
    EXPECT_TRUE(control.cancelled());
    EXPECT_THROW(control.check_cancel(), Cancelled);
    EXPECT_THROW(control.begin_stage("next", 1), Cancelled);
}

TEST(Control, fraction_runs_through_the_stages_and_never_back) {
    Control control;
    control.begin_stage("first", 0.25F);
    EXPECT_EQ(control.stage(), "first");
    control.set_stage_progress(0.5F);
    EXPECT_FLOAT_EQ(control.fraction(), 0.125F);
    control.set_stage_progress(7);  // a stage cannot overrun
    EXPECT_FLOAT_EQ(control.fraction(), 0.25F);
    control.begin_stage("second", 1);
    EXPECT_FLOAT_EQ(control.fraction(), 0.25F);
    control.set_stage_progress(1);
    EXPECT_FLOAT_EQ(control.fraction(), 1);
}

}  // namespace
}  // namespace gg
