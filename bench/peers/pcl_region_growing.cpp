// PCL's region growing: normals of k neighbours, smoothness 8 degrees, curvature 0.1: the best of a
// sweep around the tutorial's values.

#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include "bench/peers/peer.hpp"

namespace scanchor::peers {

Labels pcl_region_growing(const Points& points, const PeerOptions& options) {
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  const Cloud::Ptr cloud(new Cloud);
  for (const auto& p : points) {
    cloud->push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setSearchMethod(tree);
  estimation.setInputCloud(cloud);
  estimation.setKSearch(options.neighbours);
  estimation.compute(*normals);
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setMinClusterSize(static_cast<int>(options.minimum));
  growing.setSearchMethod(tree);
  growing.setNumberOfNeighbours(static_cast<unsigned>(options.neighbours));
  growing.setInputCloud(cloud);
  growing.setInputNormals(normals);
  growing.setSmoothnessThreshold(static_cast<float>(8.0 / 180.0 * 3.14159265358979));
  growing.setCurvatureThreshold(0.1F);
  std::vector<pcl::PointIndices> clusters;
  growing.extract(clusters);
  Labels labels(points.size(), -1);
  for (std::size_t r = 0; r < clusters.size(); ++r) {
    for (const auto i : clusters[r].indices)
      labels[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(r);
  }
  return labels;
}

}  // namespace scanchor::peers
