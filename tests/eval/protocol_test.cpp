#include "eval/protocol.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/file.hpp"
#include "scenes/classes.hpp"

namespace scanchor {
namespace {

std::string protocol_failure(const std::string& text) {
  try {
    protocol_from_text(text, "mine.yaml");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    return error.what();
  }
  return "no error";
}

TEST(Protocol, EveryBuiltInOneReadsBackToItsHash) {
  std::vector<std::string> hashes;
  for (const auto& name : builtin_protocols()) {
    const Protocol protocol = find_protocol(name);
    EXPECT_EQ(protocol.name, name);
    EXPECT_EQ(protocol_hash(protocol_from_text(protocol_to_text(protocol), name)),
              protocol_hash(protocol));
    hashes.push_back(protocol_hash(protocol));
  }
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::unique(hashes.begin(), hashes.end()), hashes.end());
}

TEST(Protocol, AnyChangedRuleChangesTheStamp) {
  Protocol protocol;
  const std::string before = protocol_stamp(protocol);
  EXPECT_THAT(before, testing::StartsWith("scanchor-1 v2 ("));
  protocol.min_points = 51;
  EXPECT_NE(protocol_stamp(protocol), before);
  protocol = Protocol{};
  protocol.ap_thresholds.pop_back();
  EXPECT_NE(protocol_stamp(protocol), before);
  protocol = Protocol{};
  protocol.large_face = 0.25;
  EXPECT_NE(protocol_stamp(protocol), before);
}

// A key that is new and left alone changes no rule: what was stored before it came is still read.
TEST(Protocol, NewKeysLeftAloneKeepTheStampsOfStoredRuns) {
  Protocol first;
  first.version = 1;
  first.merge = {};
  EXPECT_EQ(protocol_stamp(first), "scanchor-1 v1 (56bdad3528e44d61)");
}

TEST(Protocol, WhatAFileLeavesOutIsAsInItsBase) {
  const Protocol protocol =
      protocol_from_text("name: mine\nbase: semantickitti\nmin_points: 30\n", "mine.yaml");
  EXPECT_EQ(protocol.name, "mine");
  EXPECT_EQ(protocol.min_points, 30);
  EXPECT_EQ(protocol.absent_class, "zero");
}

TEST(Protocol, ErrorsNameFileLineAndCause) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(protocol_failure("name: m\nmin_point: 3\n"),
              AllOf(HasSubstr("mine.yaml: line 2"), HasSubstr("did you mean 'min_points'?")));
  EXPECT_THAT(protocol_failure("name: m\nmin_points: many\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("'many' is not a whole number")));
  EXPECT_THAT(protocol_failure("name: m\nmatch_iou: 0.3\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("outside 0.5 .. 1")));
  EXPECT_THAT(protocol_failure("name: m\nclasses: [desk, chiar]\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("did you mean 'chair'?")));
  EXPECT_THAT(protocol_failure("name: m\nap_thresholds: [0.5, 0.4]\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("must rise")));
  EXPECT_THAT(protocol_failure("name: m\nignore_flags: [ghosts]\n"),
              HasSubstr("did you mean 'ghost'?"));
  EXPECT_THAT(protocol_failure("name: m\nbase: cocoa\n"), HasSubstr("did you mean 'coco'?"));
  EXPECT_THAT(protocol_failure("min_points: 3\n"), HasSubstr("'name' is missing"));
  EXPECT_THAT(protocol_failure("name: [\n"), HasSubstr("mine.yaml: line"));
  EXPECT_THAT(protocol_failure("- 1\n"), HasSubstr("is no protocol"));
  EXPECT_THROW(find_protocol("coko"), Error);
}

TEST(Protocol, ClassesAreScoredAndMergedByName) {
  const Protocol protocol =
      protocol_from_text("name: m\nclasses: [desk, chair]\nmerge: {table: desk}\n", "mine.yaml");
  const ClassRules rules = class_rules(protocol);
  EXPECT_EQ(rules.of(*find_class("desk")), *find_class("desk"));
  EXPECT_EQ(rules.of(*find_class("table")), *find_class("desk"));
  EXPECT_EQ(rules.of(*find_class("monitor")), -1);
  EXPECT_EQ(rules.of(unlabelled), -1);
  EXPECT_EQ(rules.of(-3), -1);
  EXPECT_EQ(rules.of(100000), -1);
}

TEST(Protocol, TheFilesInTheRepositoryAreWhatTheySay) {
  const std::filesystem::path folder = std::filesystem::path(SCANCHOR_SOURCE_DIR) / "protocols";
  for (const auto& name : builtin_protocols()) {
    EXPECT_EQ(protocol_hash(read_protocol(folder / (name + ".yaml"))),
              protocol_hash(find_protocol(name)))
        << name;
  }
  EXPECT_EQ(class_rules(read_protocol(folder / "coarse.yaml")).of(*find_class("table")),
            *find_class("desk"));
}

}  // namespace
}  // namespace scanchor
