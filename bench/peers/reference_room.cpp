// The reference room and the scores that the tests of perception use, compiled in: one definition
// of the truth for both.
#include "tests/perception/support/plane_score.cpp"
#include "tests/perception/support/room.cpp"
