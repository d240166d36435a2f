#include "reasoning/relation_model.hpp"

#include "core/data_folder.hpp"
#include "core/json.hpp"

namespace scanchor {

const std::vector<RelationConstant>& relation_constants() {
  using M = RelationModel;
  static const std::vector<RelationConstant> constants = {
      {"tilt_scale", "1", "planes", "tilts of clean planes over what their fit says",
       &M::tilt_scale, 0.5, 5.0},
      {"tilt_of_points", "1", "planes",
       "tilt by points of neighbours, of the squared ratio of noise and extent", &M::tilt_of_points,
       0.01, 2.0},
      {"tilt_excess_power", "1", "planes", "power of scatter over noise that tilts grow by",
       &M::tilt_excess_power, 0.5, 6.0},
      {"flatness", "deg", "angles", "deviation of faces that are taken for exactly flat",
       &M::flatness, 0.05, 3.0},
      {"gross_share", "1", "angles", "pairs one of which lies quite otherwise", &M::gross_share,
       0.001, 0.5},
      {"gross_factor", "1", "angles", "how many deviations one of those is worth", &M::gross_factor,
       2.0, 20.0},
      {"lost_planes", "1", "angles", "planes that lie any way, a radian of deviation",
       &M::lost_planes, 0.01, 20.0},
      {"askew", "deg", "angles", "deviation of what is put down a little askew", &M::askew, 0.5,
       20.0},
      {"faces_parallel", "1", "angles", "share of pairs of faces: parallel", &M::faces_parallel,
       0.001, 0.5},
      {"faces_nearly_parallel", "1", "angles", "nearly so", &M::faces_nearly_parallel, 0.001, 0.5},
      {"faces_orthogonal", "1", "angles", "at right angles", &M::faces_orthogonal, 0.001, 0.6},
      {"faces_nearly_orthogonal", "1", "angles", "nearly so", &M::faces_nearly_orthogonal, 0.001,
       0.5},
      {"level_parallel", "1", "level", "share of faces: level", &M::level_parallel, 0.01, 0.6},
      {"level_nearly_parallel", "1", "level", "nearly so", &M::level_nearly_parallel, 0.001, 0.15},
      {"level_orthogonal", "1", "level", "upright", &M::level_orthogonal, 0.001, 0.8},
      {"level_nearly_orthogonal", "1", "level", "nearly so", &M::level_nearly_orthogonal, 0.001,
       0.5},
      {"shadow_share", "1", "ends", "sides wholly in a shadow that go on there", &M::shadow_share,
       0.05, 0.95},
      {"shadow_rate", "1", "ends", "how fast that falls, a length of what was seen",
       &M::shadow_rate, 0.2, 10.0},
      {"end_share", "1", "ends", "sides seen to end that yet go on a little", &M::end_share, 0.001,
       0.5},
      {"end_rate", "1", "ends", "how fast that falls, a length of what was seen", &M::end_rate, 1.0,
       40.0},
      {"far_share", "1", "near", "sides seen to end that yet go on far", &M::far_share, 0.0001,
       0.2},
      {"far_rate", "1", "near", "how fast that falls, a length of what was seen", &M::far_rate,
       0.05, 5.0},
      {"overlap_softness", "1", "carried", "deviation of the share over the other one",
       &M::overlap_softness, 0.01, 0.4},
      {"end_softness", "m", "carried", "deviation of lower ends of outlines", &M::end_softness,
       0.002, 0.1},
      {"carries", "1/m2", "carried", "odds that what carries goes on below what stands there",
       &M::carries, 0.05, 10.0},
      {"carrier_far_share", "1", "carried", "what carries goes on far below what stands there",
       &M::carrier_far_share, 0.0001, 0.5},
      {"carrier_far_rate", "1", "carried", "how fast that falls, a length of what was seen",
       &M::carrier_far_rate, 0.05, 5.0},
      {"tail_share", "1", "carried", "lower ends seen to end that yet go on", &M::tail_share, 0.001,
       0.5},
      {"foreign_share", "1", "carried", "lower ends that belong to something else",
       &M::foreign_share, 0.001, 0.3},
      {"foreign_scale", "m", "carried", "how far those reach, on the average", &M::foreign_scale,
       0.02, 1.0},
      {"upright_contact", "m", "carried",
       "upright faces over a level one: in contact, against a metre somewhere "
       "above",
       &M::upright_contact, 0.01, 30.0},
      {"upright_feet", "m", "carried", "on feet or a plinth", &M::upright_feet, 0.003, 10.0},
      {"upright_past", "1", "carried", "a metre past it", &M::upright_past, 0.003, 10.0},
      {"level_feet", "m", "carried",
       "level faces over a level one: on it, against a metre somewhere above", &M::level_feet,
       0.003, 10.0},
      {"near_softness", "1", "near", "deviation of distances, of the limit", &M::near_softness,
       0.001, 0.2},
      {"near_meets", "1", "near", "sides that go on far enough that then do come near",
       &M::near_meets, 0.05, 1.0},
      {"near_short", "m", "near", "outlines of two end short of them, together", &M::near_short,
       0.0002, 0.05},
      {"in_one_plane", "m", "coplanar",
       "exactly coplanar pairs, against other parallel ones a metre apart", &M::in_one_plane, 0.001,
       0.5},
      {"plane_softness", "m", "coplanar", "deviation of offsets of exact planes",
       &M::plane_softness, 0.0005, 0.03},
      {"hidden_middle", "1", "coplanar", "how far the middle of what is in a shadow lies off",
       &M::hidden_middle, 0.01, 2.0},
      {"gross_offset_share", "1", "coplanar", "pairs one of which lies quite otherwise",
       &M::gross_offset_share, 0.001, 0.5},
      {"twins", "1", "sizes", "pairs of one make, against others a unit of both logarithms",
       &M::twins, 0.001, 1.0},
      {"size_softness", "1", "sizes", "deviation of logarithms of lengths", &M::size_softness,
       0.002, 0.1},
      {"side_by_area", "1", "sizes", "deviation of sides, of that of edges by the area",
       &M::side_by_area, 0.05, 10.0},
      {"misread_share", "1", "sizes", "pairs one of which ran together with something",
       &M::misread_share, 0.001, 0.8},
      {"misread_factor", "1", "sizes", "how many deviations one of those is worth",
       &M::misread_factor, 2.0, 40.0},
      {"middle_softness", "1", "middles", "deviation of middles, of the smaller length",
       &M::middle_softness, 0.002, 0.2},
      {"in_one_line", "1", "middles", "stacked pairs, against others a squared length",
       &M::in_one_line, 0.0001, 1.0},
      {"axes_agree", "1", "middles", "other pairs with parallel sides", &M::axes_agree, 0.01, 0.99},
      {"turn_softness", "deg", "middles", "deviation of directions of sides", &M::turn_softness,
       0.05, 10.0},
      {"bearing_softness", "deg", "bearings", "deviation of bearings", &M::bearing_softness, 0.02,
       10.0},
  };
  return constants;
}

const RelationModel& relation_model() {
  static const RelationModel model = [] {
    const auto file = look_up_data_file("ontologies", "relations", ".json");
    return file ? read_relation_file(*file).model : RelationModel{};
  }();
  return model;
}

nlohmann::ordered_json relation_file_to_json(const RelationFile& file) {
  Json json;
  json["format"] = "scanchor relations 1";
  json["fitted_on"] = file.fitted_on;
  Json constants = Json::object();
  for (const auto& constant : relation_constants())
    constants[constant.name] = file.model.*constant.value;
  json["constants"] = constants;
  return json;
}

RelationFile relation_file_from_json(const nlohmann::ordered_json& json, const std::string& file) {
  const JsonReader reader(json, file);
  reader.only({"format", "fitted_on", "constants"});
  if (reader.at("format").text() != "scanchor relations 1") {
    reader.at("format").fail("is not 'scanchor relations 1'",
                             "fit it again with 'scanchor fit-relations'");
  }
  RelationFile made;
  made.fitted_on = reader.at("fitted_on").text();
  const auto constants = reader.at("constants");
  std::vector<std::string> names;
  for (const auto& constant : relation_constants()) {
    names.emplace_back(constant.name);
    made.model.*constant.value = constants.at(constant.name).number_in(constant.low, constant.high);
  }
  constants.only(names);
  const RelationModel& m = made.model;
  if (m.faces_parallel + m.faces_nearly_parallel + m.faces_orthogonal + m.faces_nearly_orthogonal >=
          1.0 ||
      m.level_parallel + m.level_nearly_parallel + m.level_orthogonal + m.level_nearly_orthogonal >=
          1.0)
    constants.fail("shares of angles make more than 1",
                   "fit it again with 'scanchor fit-relations'");
  return made;
}

RelationFile read_relation_file(const std::filesystem::path& path) {
  return relation_file_from_json(read_json(path), path.string());
}

void write_relation_file(const std::filesystem::path& path, const RelationFile& file) {
  write_json(path, relation_file_to_json(file));
}

}  // namespace scanchor
