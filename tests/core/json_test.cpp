#include "core/json.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file.hpp"

namespace scanchor {
namespace {
namespace fs = std::filesystem;

std::string data_error(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    return error.what();
  }
  return "nothing was thrown";
}

class JsonFile : public ::testing::Test {
 protected:
  std::string read_error(const std::string& content) {
    write_file(path_, content);
    const std::string line = data_error([&] { (void)read_json(path_); });
    return line.substr(std::min(line.size(), path_.string().size()));
  }
  void TearDown() override { fs::remove(path_); }
  fs::path path_ = fs::path(::testing::TempDir()) / "scanchor_json_test.json";
};

TEST_F(JsonFile, WritesAndReadsBackInOrder) {
  const Json json = {{"z", 0.1}, {"a", {1, 2}}, {"t", "w\n"}};
  write_json(path_, json);
  EXPECT_EQ(read_json(path_).dump(), json.dump());
  EXPECT_EQ(read_file(path_).back(), '\n');
}

TEST_F(JsonFile, ErrorsHaveLineAndColumn) {
  EXPECT_EQ(read_error(""), ": is empty, JSON was expected");
  EXPECT_EQ(read_error("{\n  \"a\": 1,\n  oops\n}\n"), ": line 3, column 3: is no valid JSON here");
  EXPECT_EQ(read_error("{\"a\": [1, 2"), ": line 1, column 12: JSON ends too early");
  EXPECT_NE(read_error("{\"a\": 1e999}").find("number"), std::string::npos);
  EXPECT_NE(read_error("{\"a\": \"\xff\"}").find("line 1"), std::string::npos);
}

TEST_F(JsonFile, TextThatIsNoUtf8StillWrites) {
  write_json(path_, Json{{"file", "caf\xe9.pcd"}});
  EXPECT_TRUE(read_json(path_).contains("file"));
}

TEST(JsonReader, ReadsValues) {
  const Json json =
      Json::parse(R"({"n": 2.5, "i": -3, "b": true, "t": "x", "v": [1, 2, 3], "w": [4, 5],
    "big": 18446744073709551615,
    "pose": {"position": [1, 2, 3], "quaternion": [0.7071067811865476, 0, 0, 0.7071067811865476]}})");
  const JsonReader reader(json, "f.json");
  EXPECT_EQ(reader.at("n").number(), 2.5);
  EXPECT_EQ(reader.at("i").integer(), -3);
  EXPECT_EQ(reader.at("big").natural(), 18446744073709551615ULL);
  EXPECT_TRUE(reader.at("b").boolean());
  EXPECT_EQ(reader.at("t").text(), "x");
  EXPECT_EQ(reader.at("v").vector3(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(reader.at("w").vector2(), Eigen::Vector2d(4, 5));
  EXPECT_TRUE(reader.has("n"));
  EXPECT_FALSE(reader.has("m"));
  const Eigen::Isometry3d pose = reader.at("pose").pose();
  EXPECT_LT((pose * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(1, 3, 3)).norm(), 1e-15);
  EXPECT_LT((JsonReader(to_json(pose), "g").pose().matrix() - pose.matrix()).norm(), 1e-15);
}

TEST(JsonReader, ErrorsNameThePlace) {
  const Json json = Json::parse(R"({"instances": [{"size": [1, -1]}, {"size": "big"}], "q": 1,
    "big": 18446744073709551615,
    "pose": {"position": [0, 0, 0], "quaternion": [2, 0, 0, 0]}})");
  const JsonReader r(json, "scene.json");
  const auto instance = [&](std::size_t i) { return r.at("instances").at(i).at("size"); };
  EXPECT_EQ(data_error([&] { (void)instance(0).at(1).number_in(0, 9); }),
            "scene.json: instances[0].size[1]: must lie in 0 .. 9, is -1");
  EXPECT_EQ(data_error([&] { (void)instance(1).number(); }),
            "scene.json: instances[1].size: must be a number, is \"big\"");
  EXPECT_EQ(data_error([&] { (void)instance(0).vector3(); }),
            "scene.json: instances[0].size: must be three numbers");
  EXPECT_EQ(data_error([&] { (void)r.at("none"); }), "scene.json: 'none' is missing");
  EXPECT_EQ(data_error([&] { (void)r.at("instances").at(2); }),
            "scene.json: instances: has no element 2");
  EXPECT_EQ(data_error([&] { (void)r.at("q").text(); }), "scene.json: q: must be a text, is 1");
  EXPECT_EQ(data_error([&] { (void)r.at("q").size(); }), "scene.json: q: must be a list");
  EXPECT_EQ(data_error([&] { (void)r.at("q").at("x"); }), "scene.json: q: must be an object");
  EXPECT_NE(data_error([&] { (void)r.at("big").integer(); }).find("too large"), std::string::npos);
  EXPECT_NE(data_error([&] { (void)instance(0).at(1).natural(); }).find("whole number from 0"),
            std::string::npos);
  EXPECT_NE(data_error([&] { (void)r.at("pose").pose(); }).find("must have length 1"),
            std::string::npos);
  EXPECT_NE(data_error([&] {
              r.only({"instance", "q", "pose", "big"});
            }).find("unknown key 'instances'; did you mean 'instance'?"),
            std::string::npos);
}

}  // namespace
}  // namespace scanchor
