#include "reasoning/ontology.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "core/error.hpp"
#include "core/file.hpp"

namespace scanchor {
namespace {

struct Folder : testing::Test {
  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "scanchor_ontology_test";
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::string write(const std::string& name, const std::string& text) const {
    write_file(folder / name, text);
    return (folder / name).string();
  }
};

TEST_F(Folder, ImportsComeFirstAndMayBeReplaced) {
  write("base.sdl", "axiom floor:\n    lowest\nclass desk:\n    above a floor\n");
  const auto path = write("own.sdl", "import base\nclass desk, table:\n    on a floor\n");
  const auto ontology = read_ontology(path);
  ASSERT_EQ(ontology.classes.size(), 2U);
  EXPECT_EQ(ontology.name, "own");
  EXPECT_EQ(ontology.find("floor"), 0);
  EXPECT_EQ(ontology.find("table"), 1);
  EXPECT_EQ(clause_text(ontology.classes[1].clauses[0]), "on a floor");
  EXPECT_EQ(ontology.find("tables"), -1);
  EXPECT_EQ(ontology.find("tables", true), 1);
}

TEST_F(Folder, CirclesOfImportsAreRefused) {
  write("a.sdl", "import b\nclass x:\n    lowest\n");
  const auto path = write("b.sdl", "import a\nclass y:\n    lowest\n");
  EXPECT_THROW(read_ontology(path), Error);
}

TEST_F(Folder, FoundByVariableAndMissingOnesAreListed) {
  write("mine.sdl", "class x:\n    lowest\n");
  ASSERT_EQ(setenv("SCANCHOR_ONTOLOGIES", folder.c_str(), 1), 0);
  EXPECT_EQ(find_ontology("mine").classes.size(), 1U);
  try {
    find_ontology("mien");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'mine'"), std::string::npos)
        << error.what();
  }
  unsetenv("SCANCHOR_ONTOLOGIES");
}

TEST(Ontology, ShippedOnesAreFoundByName) {
  std::set<std::string> names;
  for (const auto* name : {"office", "home", "storage"}) {
    for (const auto& description : find_ontology(name).classes) {
      if (description.part_of.empty()) names.insert(description.name());
    }
  }
  EXPECT_GE(names.size(), 30U) << "things, parts not counted";
  EXPECT_EQ(find_ontology("paper").classes.size(), 5U);
}

TEST(Ontology, OrderPutsNeedsFirstAndParentsCount) {
  const auto ontology = parse_ontology(
      "class c:\n    on a b\nclass b is a a:\n    lowest\nclass a:\n    vertical\n    usually near "
      "a c\n",
      "x.sdl");
  EXPECT_EQ(evaluation_order(ontology), (std::vector<int>{2, 1, 0}));
  EXPECT_EQ(all_clauses(ontology, 1).size(), 3U);
  EXPECT_EQ(all_clauses(ontology, 1)[0].kind, ClauseKind::vertical);
}

}  // namespace
}  // namespace scanchor
