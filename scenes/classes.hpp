#pragma once
// The stable class list shared by scenes, data sets, predictions and scores.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scanchor {

/// Index into the class list; 0 is "unlabelled". The numbers are part of the data-set format and
/// never change meaning.
using ClassId = std::int32_t;
inline constexpr ClassId unlabelled = 0;

struct ClassInfo {
  ClassId id;
  std::string_view name;   ///< singular, lower case, with blanks: "drawer unit"
  bool thing;              ///< countable (COCO's "thing"); false: stuff (floor, wall, ceiling)
  std::string_view s3dis;  ///< nearest of the 13 S3DIS classes
  std::array<std::uint8_t, 3> color;  ///< RGB for pictures and label maps
};

/// All classes in order of their id.
const std::vector<ClassInfo>& class_list();
/// Class by id; the unlabelled class for an id that is none.
const ClassInfo& class_info(ClassId id);
/// Id by name, or nothing.
std::optional<ClassId> find_class(std::string_view name);

/// The 13 classes of S3DIS (Armeni et al., CVPR 2016) in the order of its loaders.
const std::vector<std::string_view>& s3dis_classes();
/// Place of a class in s3dis_classes().
std::int32_t s3dis_index(ClassId id);

/// The `data_cfg` file that semantic-kitti-api wants: labels, color_map (blue, green, red), and a
/// learning map onto the 13 classes of S3DIS (learning ids 1..13; 0 is unlabelled and ignored).
std::string semantic_kitti_yaml();

}  // namespace scanchor
