#pragma once
// What all cloud files have in common: columns of numbers of ten types, packed into records. The
// formats differ in their headers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/point_cloud.hpp"

namespace scanchor {

enum class ScalarType : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

/// Bytes of one value.
std::size_t scalar_size(ScalarType type);

/// A column in a block of bytes: value i lies at offset + i * stride.
struct Column {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::size_t offset = 0;
  std::size_t stride = 0;
};

/// Lays columns one behind the other into records; fills offset and stride and returns the record's
/// size in bytes.
std::size_t lay_out_records(std::vector<Column>& columns);

/// Points from the columns x, y, z, fields from all others. Fields keep their types; int8 and int16
/// widen to int32, 64-bit integers become int32 or uint32 where all values fit and double
/// elsewhere. `bytes` must hold every value (the caller has checked). Throws Error(bad_data) if x,
/// y or z is missing or a name appears twice.
PointCloud cloud_from_columns(const std::vector<Column>& columns, std::string_view bytes,
                              std::size_t count, bool swap_bytes, const std::string& file);

/// One number from text, written to `out` in the machine's own byte order. Whole numbers may be
/// written as "3.0"; "nan" and "inf" are numbers for the two real types. False: it is no number, or
/// does not fit the type.
bool parse_scalar(std::string_view token, ScalarType type, char* out);

/// A column to be written: an axis of the positions or a field.
struct OutColumn {
  std::string name;  ///< blanks replaced by '_'
  ScalarType type;
  int axis = -1;                 ///< 0, 1, 2: x, y, z
  const Field* field = nullptr;  ///< otherwise
};

/// x, y, z (float32, or float64 where a coordinate needs it), then all fields in their order.
/// Throws Error(bad_data) if a field has another length than the points.
std::vector<OutColumn> columns_of(const PointCloud& cloud, const std::string& file);

/// Little-endian records of all columns, one a point.
std::string pack_records(const PointCloud& cloud, const std::vector<OutColumn>& columns);
/// Little-endian columns, one behind the other (the order of binary_compressed PCD).
std::string pack_columns(const PointCloud& cloud, const std::vector<OutColumn>& columns);
/// One line a point, numbers as the shortest text that reads back to the same bits.
std::string text_records(const PointCloud& cloud, const std::vector<OutColumn>& columns);

/// "x y z qw qx qy qz" of a pose, as VIEWPOINT lines and `sensor_pose` comments have it; and back.
/// An unusable quaternion: false.
std::string pose_text(const Eigen::Isometry3d& pose);
bool parse_pose(std::string_view text, Eigen::Isometry3d& pose);
inline constexpr std::string_view pose_comment = "sensor_pose";

}  // namespace scanchor
