#include "reasoning/sdl_hints.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reasoning/query.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

/// A clause as a newcomer writes it, where the caret stands, and the hint.
struct Slip {
  const char* clause;
  int column;
  const char* hint;
};

class ClauseSlip : public testing::TestWithParam<Slip> {};

/// In the first line: where, and what to write instead.
void expect_hint(const std::string& said, const std::string& line, const Slip& slip) {
  EXPECT_EQ(said.rfind(line + std::to_string(slip.column) + ": ", 0), 0U) << said;
  EXPECT_NE(said.substr(0, said.find('\n')).find(slip.hint), std::string::npos) << said;
}

TEST_P(ClauseSlip, IsMetWithAHint) {
  const std::string text =
      "class desk:\n    horizontal\nclass stool:\n    " + std::string(GetParam().clause) + "\n";
  try {
    parse_ontology(text, "own.sdl");
    FAIL() << "was read";
  } catch (const Error& error) {
    const std::string said = error.what();
    expect_hint(said, "own.sdl:4:", GetParam());
    EXPECT_NE(said.find("\n  " + std::string(GetParam().column - 1, ' ') + "^"), std::string::npos)
        << said;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, ClauseSlip,
    testing::Values(
        Slip{"no desk above", 8, "write 'not above a desk'"},
        Slip{"not desk", 9, "'not near a desk'"},
        Slip{"not horizontal", 9, "'not' denies a relation"},
        Slip{"near desk", 10, "write 'a desk'"}, Slip{"on the", 11, "a name of a class"},
        Slip{"next to a desk", 5, "write 'near a desk'"},
        Slip{"beside desk", 5, "write 'near a desk'"},
        Slip{"under a desk", 5, "write 'below a desk'"},
        Slip{"on top of a desk", 8, "write 'on a desk'"},
        Slip{"touches a desk", 5, "write 'touching a desk'"},
        Slip{"parallel desk", 5, "write 'parallel to a desk'"},
        Slip{"without a desk", 5, "write 'not near a desk'"},
        Slip{"with a desk", 5, "'near a desk'"}, Slip{"has a desk", 5, "a thing is no clause"},
        Slip{"is horizontal", 5, "write 'horizontal'"},
        Slip{"must be vertical", 5, "write 'vertical'"}, Slip{"flat", 5, "write 'horizontal'"},
        Slip{"length 0.3..0.5 m", 5, "write 'extension 0.3..0.5 m'"},
        Slip{"depth at most 0.5 m", 5, "write 'width at most 0.5 m'"},
        Slip{"height 40-50 cm", 12, "write 'height 40..50 cm'"},
        Slip{"height 0.4 to 0.5 m", 12, "write 'height 0.4..0.5 m'"},
        Slip{"height 0.4m..0.5m", 12, "write 'height 0.4..0.5 m'"},
        Slip{"height between 0.4 and 0.5 m", 12, "write 'height 0.4..0.5 m'"},
        Slip{"height > 0.4 m", 12, "write 'height at least 0.4 m'"},
        Slip{"height less than 0.4 m", 12, "write 'height at most 0.4 m'"},
        Slip{"height 0.4 m", 12, "write 'height about 0.4 m'"},
        Slip{"0.4..0.5 m high", 5, "begins with what is measured"},
        Slip{"optional near a desk", 5, "write 'usually near a desk'"},
        Slip{"red", 5, "colours and materials are not measured"},
        Slip{"horizontal, rectangular", 15, "one clause a line"},
        Slip{"usually", 12, "write for example: horizontal"}));

class QuestionSlip : public testing::TestWithParam<Slip> {};

TEST_P(QuestionSlip, IsMetWithAHint) {
  try {
    parse_query(GetParam().clause, test::office());
    FAIL() << "was read";
  } catch (const Error& error) {
    const std::string said = error.what();
    expect_hint(said, "question:1:", GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, QuestionSlip,
    testing::Values(Slip{"chair by the desk", 7, "write 'near the desk'"},
                    Slip{"chair next to the desk", 7, "write 'near the desk'"},
                    Slip{"chair under the desk", 7, "write 'below the desk'"},
                    Slip{"chair beside desk", 7, "write 'near a desk'"},
                    Slip{"where's the desk", 1, "'where is the desk'"},
                    Slip{"find me a chair", 6, "ask for the thing alone"},
                    Slip{"is a chair near the desk", 1, "is there a chair near a desk"},
                    Slip{"red chair", 1, "colours and materials are not measured"},
                    Slip{"chairs in the office", 8, "rooms and parts of rooms"},
                    Slip{"how big is the desk", 1, "the answer has its size"},
                    Slip{"table or desk", 7, "ask twice"},
                    Slip{"monitor on top of a desk", 16, "'on top of' is 'on'"},
                    Slip{"the desk that has a monitor", 19, "desk with a monitor"},
                    Slip{"desk larger than 1 m2", 6, "with area at least 1 m2"},
                    Slip{"chair nera a desk", 7, "did you mean 'near'"},
                    Slip{"chair near a dsek", 14, "did you mean 'desk'"}));

}  // namespace
}  // namespace scanchor
