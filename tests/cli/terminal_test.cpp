#include "cli/terminal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "cli/live_line.h"
#include "cli/progress.h"

namespace rad::cli {
namespace {

TEST(Color, CommandLineBeatsAll) {
  Terminal terminal;
  terminal.no_color = "1";
  EXPECT_TRUE(use_color(ColorChoice::Always, terminal));
  terminal.no_color = "";
  terminal.force_color = "1";
  EXPECT_FALSE(use_color(ColorChoice::Never, terminal));
}

TEST(Color, EnvironmentInOrder) {
  Terminal terminal;
  EXPECT_FALSE(use_color(ColorChoice::Auto, terminal));
  terminal.clicolor_force = "1";
  EXPECT_TRUE(use_color(ColorChoice::Auto, terminal));
  terminal.no_color = "1";
  EXPECT_FALSE(use_color(ColorChoice::Auto, terminal));
  terminal.force_color = "1";
  EXPECT_TRUE(use_color(ColorChoice::Auto, terminal));
  terminal.force_color = "0";
  EXPECT_FALSE(use_color(ColorChoice::Auto, terminal));
}

TEST(Color, TerminalThatIsNotDumb) {
  Terminal terminal;
  terminal.out_is_terminal = true;
  EXPECT_TRUE(use_color(ColorChoice::Auto, terminal));
  terminal.term = "dumb";
  EXPECT_FALSE(use_color(ColorChoice::Auto, terminal));
}

TEST(Progress, WipesItsLine) {
  std::ostringstream err;
  {
    Progress progress(err, true, 80, 2);
    progress.show(0, "a\x1b.obj");
  }
  EXPECT_EQ(err.str(), "\r\x1b[K[                        ] 0/2 a\xEF\xBF\xBD.obj\r\x1b[K");
}

TEST(Progress, FitsTheTerminalAndKeepsTheEndOfPaths) {
  std::ostringstream err;
  Progress progress(err, true, 50, 2000);
  progress.show(1000, "a/long/path/of/folders/with/a/ä/model.obj");
  EXPECT_EQ(err.str(), "\r\x1b[K[############            ] 1000/2000 …/model.obj");
}

TEST(Progress, SilentWhenOff) {
  std::ostringstream err;
  { Progress(err, false, 80, 1).show(0, "a.obj"); }
  EXPECT_EQ(err.str(), "");
}

TEST(LiveLine, WipesItselfAtTheEnd) {
  std::ostringstream err;
  {
    LiveLine line(err, true);
    line.show("reading");
  }
  EXPECT_EQ(err.str(), "\r\x1b[Kreading\r\x1b[K");
}

TEST(LiveLine, WipedOnceBeforeOtherWords) {
  std::ostringstream err;
  LiveLine line(err, true);
  line.show("reading");
  line.wipe();
  err << "done";
  line.wipe();
  EXPECT_EQ(err.str(), "\r\x1b[Kreading\r\x1b[Kdone");
}

TEST(LiveLine, SilentWhenOff) {
  std::ostringstream err;
  {
    LiveLine line(err, false);
    line.show("reading");
  }
  EXPECT_EQ(err.str(), "");
}

}  // namespace
}  // namespace rad::cli
