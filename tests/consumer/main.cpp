#include <scanchor/cloud/io.hpp>
#include <scanchor/perception/perceive.hpp>

#include <cstdio>

int main(int, char** arguments) {
  const auto cloud = scanchor::read_cloud(arguments[1]);
  const auto surfaces = scanchor::perceive(cloud, {});
  std::printf("%zu points, %zu surfaces\n", cloud.size(), surfaces.surfaces.size());
}
