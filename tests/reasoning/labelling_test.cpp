#include "reasoning/labelling.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(Labelling, ThingsAreTheOwners) {
  Labelling labelling;
  labelling.entity_of_surface = {0, 4, 4, 3};
  labelling.entities.resize(5);
  EXPECT_EQ(things(labelling), (std::vector<std::int32_t>{0, 3, 4}));
}

}  // namespace
}  // namespace scanchor
