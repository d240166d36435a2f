#include "reasoning/reference_rooms.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "reasoning/levelled.hpp"

namespace scanchor {

namespace {

constexpr double unit_of_directions = 1e-4;  // of directions, areas [m2] and deviations [m]
constexpr double unit_of_lengths = 1e-3;     // of lengths [m]
constexpr double unit_of_shares = 1e-2;
constexpr double unit_of_tilts = 1e-7;  // [rad2]

/// The numbers of an item in one order, for writing and for reading.
template <typename Number>
void walk(Item& item, Number&& number) {
  const auto vector = [&](Eigen::Vector3d& v, double unit) {
    for (int i = 0; i < 3; ++i) number(v[i], unit);
  };
  vector(item.center, unit_of_lengths);
  vector(item.centroid, unit_of_lengths);
  vector(item.normal, unit_of_directions);
  vector(item.along, unit_of_directions);
  vector(item.across, unit_of_directions);
  for (Quantity* q :
       {&item.area, &item.extension, &item.width, &item.height, &item.rectangularness}) {
    number(q->value, unit_of_directions);
    number(q->sigma, unit_of_directions);
    number(q->hidden, unit_of_shares);
  }
  for (double& side : item.open) number(side, unit_of_shares);
  number(item.edge_sigma, unit_of_directions);
  number(item.offset_sigma, unit_of_directions);
  number(item.z_low, unit_of_lengths);
  number(item.z_high, unit_of_lengths);
  number(item.z_sigma, unit_of_directions);
  vector(item.box.min(), unit_of_lengths);
  vector(item.box.max(), unit_of_lengths);
  for (Eigen::Vector2d* v : {&item.footprint.u, &item.footprint.v}) {
    number(v->x(), unit_of_lengths);
    number(v->y(), unit_of_lengths);
  }
}

Json to_numbers(Item item) {
  Json numbers = Json::array();
  walk(item, [&](double& x, double unit) {
    numbers.push_back(static_cast<std::int64_t>(std::llround(x / unit)));
  });
  const Eigen::Matrix3d& C = item.normal_covariance;
  for (const double x : {item.along.dot(C * item.along), item.along.dot(C * item.across),
                         item.across.dot(C * item.across)})
    numbers.push_back(static_cast<std::int64_t>(std::llround(x / unit_of_tilts)));
  numbers.push_back(item.has_shape ? 1 : 0);
  return numbers;
}

Item from_numbers(const JsonReader& numbers, std::int32_t id) {
  Item item;
  item.id = id;
  std::size_t next = 0;
  const Json& raw = numbers.raw();  // a hundred thousand of them: no words for the place of each
  const auto take = [&](double unit) {
    if (next >= numbers.size() || !raw[next].is_number_integer())
      numbers.fail("is no list of whole numbers as long as an item's",
                   "make it again with 'scanchor fit'");
    return raw[next++].get<double>() * unit;
  };
  item.box = Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  walk(item, [&](double& x, double unit) { x = take(unit); });
  for (Eigen::Vector3d* v : {&item.normal, &item.along, &item.across}) {
    if (v->norm() < 0.5)
      numbers.fail("holds a direction without a length", "make it again with 'scanchor fit'");
    v->normalize();
  }
  const double aa = take(unit_of_tilts), ab = take(unit_of_tilts), bb = take(unit_of_tilts);
  const Eigen::Vector3d &a = item.along, &b = item.across;
  item.normal_covariance = aa * a * a.transpose() + bb * b * b.transpose() +
                           ab * (a * b.transpose() + b * a.transpose());
  item.tilt_sigma = tilt_sigma_of(item.normal_covariance);
  item.has_shape = take(1.0) > 0.5;
  item.half_length = 0.5 * item.extension.value;
  item.half_width = 0.5 * item.width.value;
  item.z = item.center.z();
  item.footprint.center = item.center.head<2>();
  return item;
}

}  // namespace

ReferenceRoom make_reference_room(const TrainingScene& scene, const ReasonOptions& options) {
  const Levelled levelled = level(scene.surfaces, options);
  ReferenceRoom room;
  room.around = levelled.around;
  room.items = make_items(scene.surfaces, levelled.R_level_cloud);
  room.classes = scene.classes;
  return room;
}

void write_reference_rooms(const std::filesystem::path& path,
                           const std::vector<ReferenceRoom>& rooms, const std::string& made_of) {
  std::vector<std::string> names;
  for (const auto& room : rooms)
    names.insert(names.end(), room.classes.begin(), room.classes.end());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const Json said = made_of;
  std::string text = "{\"format\": \"scanchor rooms 1\",\n\"made_of\": " + said.dump() +
                     ",\n\"classes\": " + Json(names).dump() + ",\n\"rooms\": [";
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const auto& room = rooms[r];
    Json json;
    json["up_sigma"] = room.around.up_sigma;
    if (room.around.viewpoint) {
      const auto& v = *room.around.viewpoint;
      json["viewpoint"] = {v.x(), v.y(), v.z()};
    }
    Json classes = Json::array(), items = Json::array();
    for (const auto& name : room.classes)
      classes.push_back(std::lower_bound(names.begin(), names.end(), name) - names.begin());
    for (const auto& item : room.items) items.push_back(to_numbers(item));
    json["classes"] = classes;
    json["items"] = items;
    text += (r == 0 ? "\n" : ",\n") + json.dump();
  }
  write_file(path, text + "\n]}\n");
}

std::vector<ReferenceRoom> read_reference_rooms(const std::filesystem::path& path) {
  const Json json = read_json(path);
  const JsonReader reader(json, path.string());
  reader.only({"format", "made_of", "classes", "rooms"});
  if (reader.at("format").text() != "scanchor rooms 1")
    reader.at("format").fail("is not 'scanchor rooms 1'", "make it again with 'scanchor fit'");
  std::vector<std::string> names;
  const auto list = reader.at("classes");
  for (std::size_t i = 0; i < list.size(); ++i) names.push_back(list.at(i).text());
  std::vector<ReferenceRoom> rooms;
  const auto all = reader.at("rooms");
  for (std::size_t r = 0; r < all.size(); ++r) {
    const auto one = all.at(r);
    one.only({"up_sigma", "viewpoint", "classes", "items"});
    ReferenceRoom room;
    room.around.up_sigma = one.at("up_sigma").number_in(0.0, 1.0);
    if (one.has("viewpoint")) {
      const auto v = one.at("viewpoint");
      room.around.viewpoint = Eigen::Vector3d(
          v.at(0).number_in(-1e6, 1e6), v.at(1).number_in(-1e6, 1e6), v.at(2).number_in(-1e6, 1e6));
    }
    const auto items = one.at("items"), classes = one.at("classes");
    if (items.size() != classes.size())
      classes.fail("are not as many as the items", "make it again with 'scanchor fit'");
    for (std::size_t i = 0; i < items.size(); ++i) {
      const double name = classes.at(i).number_in(0.0, static_cast<double>(names.size()) - 1.0);
      room.classes.push_back(names[static_cast<std::size_t>(name)]);
      room.items.push_back(from_numbers(items.at(i), static_cast<std::int32_t>(i)));
    }
    rooms.push_back(std::move(room));
  }
  return rooms;
}

}  // namespace scanchor
