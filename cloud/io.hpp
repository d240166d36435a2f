#pragma once
// Reading and writing clouds by the ending of the file's name.

#include <filesystem>

#include "cloud/point_cloud.hpp"

namespace scanchor {

/// Reads PCD (ascii, binary, binary_compressed), PLY (ascii, binary of both byte orders), XYZ text
/// (x y z and further columns, blanks or commas, # comments), SemanticKITTI .bin (with a .label
/// file beside or in ../labels). The format is found from the content first and the ending second.
/// Throws Error(bad_data) naming file, place and cause: empty file, truncated data, unknown format,
/// a header that contradicts itself. Non-finite points are kept (organized clouds need their
/// places).
PointCloud read_cloud(const std::filesystem::path& path);

enum class CloudFormat {
  pcd_ascii,
  pcd_binary,
  pcd_binary_compressed,
  ply_ascii,
  ply_binary,
  xyz,
  kitti_bin
};

/// Writes the format that the ending names (.pcd: binary, .ply: binary_little_endian, .xyz/.txt:
/// text, .bin: SemanticKITTI). Positions are float32 in PCD and PLY unless a coordinate needs more
/// (then float64). All fields are written, in their order.
void write_cloud(const std::filesystem::path& path, const PointCloud& cloud);
void write_cloud(const std::filesystem::path& path, const PointCloud& cloud, CloudFormat format);

}  // namespace scanchor
