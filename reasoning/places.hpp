#pragma once
// Questions for room: a free place on a thing, and where a robot could stand in front of one.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/answer.hpp"

namespace scanchor {

struct PlaceQuestion {
  enum class Kind { free_place, standing_place };
  Kind kind = Kind::free_place;
  double length = 0.3, width = 0.3;  ///< [m] of the free rectangle
  double diameter = 0.6;             ///< [m] of the robot
  Query thing;                       ///< on what, in front of what
  std::string text;                  ///< as asked
};

/// "free place of 30 x 40 cm on a desk", "where could a robot of 60 cm stand in front of the
/// cabinet", "place to stand in front of the cabinet". Nothing where the question is another one.
/// Throws Error(wrong_usage) as parse_query does.
std::optional<PlaceQuestion> parse_place_question(const std::string& text,
                                                  const Ontology& ontology);
/// How it was read.
std::string place_question_text(const PlaceQuestion& question);

struct FoundPlace {
  std::int32_t thing = -1;  ///< entity on which, or in front of which
  Eigen::Isometry3d T_cloud_place =
      Eigen::Isometry3d::Identity();               ///< z up; x along the longer side
                                                   ///< of the place, or to the thing
  Eigen::Vector2d size = Eigen::Vector2d::Zero();  ///< [m] along x and y
  double margin = 0.0;                             ///< [m] free on all sides besides; of a robot 0
  double unseen = 0.0;                             ///< [0, 1] share of it that was not seen
  double distance = 0.0;  ///< [m] of a robot's middle to the front of the thing
};

struct PlaceAnswer {
  PlaceQuestion question;
  Answer thing;  ///< what the thing was found to be
  Answer::Status status =
      Answer::Status::not_found;   ///< not_seen: only where the scan has not looked
  std::vector<FoundPlace> places;  ///< one a thing, in the order of things
};

/// A free place lies on the largest level face of the thing, turned as its sides are, on what was
/// seen of it, below nothing and through nothing for 50 cm upwards, with as much margin as there is
/// and as near to the middle as that leaves. A robot stands on the seen floor, clear of everything
/// up to 1.8 m, before the face that was seen or the side nearest to the sensor, no farther aside
/// than the thing is wide, as near to 65 cm before it as there is room, at most 1.5 m. Where that
/// is not to be had, the parts that were not seen are tried. Throws Error(wrong_usage) where no
/// floor was found to stand on.
PlaceAnswer find_places(const PlaceQuestion& question, const Surfaces& surfaces,
                        const Labelling& labelling, const SceneThings& scene);

std::string places_text(const PlaceAnswer& answer, const SceneThings& scene);
nlohmann::ordered_json places_to_json(const PlaceAnswer& answer, const SceneThings& scene);

}  // namespace scanchor
