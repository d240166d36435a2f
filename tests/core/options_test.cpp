#include "core/options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace scanchor {
namespace {

struct Inner {
  double sigma = 0.01;
  int lines = 200;
  void describe(OptionList& list) {
    list.add("sigma", sigma, "m", "noise of the range", 0.0, 1.0);
    list.add("lines", lines, "1", "lines of the sweep", 1, 10000);
  }
};

struct Outer {
  bool merge = false;
  std::uint64_t seed = 1;
  std::string echo = "first";
  Inner lidar;
  void describe(OptionList& list) {
    list.add("merge", merge, "merge the scans");
    list.add("seed", seed, "first number");
    list.add("echo", echo, "which echo", {"first", "strongest", "last"});
    list.add_group("lidar", lidar);
  }
};

std::string usage_error(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_usage);
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Options, SetsEachKindByItsDottedName) {
  Outer outer;
  OptionList list;
  outer.describe(list);
  list.set("merge", "on");
  list.set("seed", "18446744073709551615");
  list.set("echo", "last");
  list.set_assignment("lidar.sigma=2.5e-2");
  list.set_assignment("lidar.lines=7");
  EXPECT_TRUE(outer.merge);
  EXPECT_EQ(outer.seed, 18446744073709551615ULL);
  EXPECT_EQ(outer.echo, "last");
  EXPECT_EQ(outer.lidar.sigma, 0.025);
  EXPECT_EQ(outer.lidar.lines, 7);
  for (const char* off : {"false", "off", "no", "0"}) {
    outer.merge = true;
    list.set("merge", off);
    EXPECT_FALSE(outer.merge) << off;
  }
}

TEST(Options, ErrorsNameTheOptionAndHelp) {
  Outer outer;
  OptionList list;
  outer.describe(list);
  EXPECT_EQ(usage_error([&] { list.set("lidar.sgima", "1"); }),
            "unknown option 'lidar.sgima'; did you mean 'lidar.sigma'?");
  EXPECT_EQ(usage_error([&] { list.set("lidar.sigma", "2"); }),
            "option lidar.sigma: 2 is outside 0 .. 1 m");
  EXPECT_EQ(usage_error([&] { list.set("lidar.sigma", "nan"); }).substr(0, 26),
            "option lidar.sigma: nan is");
  EXPECT_EQ(usage_error([&] { list.set("lidar.lines", "1.5"); }),
            "option lidar.lines: '1.5' is not a whole number");
  EXPECT_EQ(usage_error([&] { list.set("lidar.lines", "9999999999"); }),
            "option lidar.lines: '9999999999' is not a whole number");
  EXPECT_EQ(usage_error([&] { list.set("seed", "-1"); }),
            "option seed: '-1' is not a whole number");
  EXPECT_EQ(usage_error([&] { list.set("merge", "maybe"); }),
            "option merge: 'maybe' is neither true nor false");
  EXPECT_EQ(usage_error([&] { list.set("echo", "lst"); }),
            "option echo: 'lst' is not a choice; did you mean 'last'?");
  EXPECT_EQ(usage_error([&] { list.set_assignment("=3"); }),
            "'=3' is no assignment; write name=value");
  EXPECT_EQ(outer.lidar.sigma, 0.01);
}

TEST(Options, GetReadsBackToTheSameBits) {
  Outer outer;
  OptionList list;
  outer.describe(list);
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, 0.30000000000000004}) {
    outer.lidar.sigma = value;
    const std::string text = list.get("lidar.sigma");
    outer.lidar.sigma = 0;
    list.set("lidar.sigma", text);
    EXPECT_EQ(outer.lidar.sigma, value) << text;
  }
}

TEST(Options, JsonIsNestedAndKeepsTheOrder) {
  Outer outer;
  OptionList list;
  outer.describe(list);
  EXPECT_EQ(list.to_json().dump(),
            R"({"merge":false,"seed":1,"echo":"first","lidar":{"sigma":0.01,"lines":200}})");
}

TEST(Options, MarkdownHasOneRowAnOption) {
  Outer outer;
  OptionList list;
  outer.describe(list);
  const std::string table = list.to_markdown();
  EXPECT_NE(table.find("| `lidar.sigma` | 0.01 | m | 0 .. 1 | noise of the range |"),
            std::string::npos);
  EXPECT_NE(table.find("| `echo` | first |  | first, strongest, last | which echo |"),
            std::string::npos);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 7);
}

}  // namespace
}  // namespace scanchor
