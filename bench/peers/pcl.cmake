# PCL for the peer that needs it, as the target scanchor_pcl where libpcl-dev is. Not by find_package(PCL): PCLConfig.cmake asks for
# all of VTK, and that for MPI and the C language, though region growing needs none of it.
include_guard(GLOBAL)
find_path(PCL_REGION_GROWING_INCLUDE pcl/segmentation/region_growing.h
          PATH_SUFFIXES pcl-1.15 pcl-1.14 pcl-1.13 pcl-1.12 pcl-1.11 pcl-1.10)
set(pcl_libraries)
foreach(part segmentation features filters search kdtree octree sample_consensus common)
  find_library(PCL_${part}_LIBRARY pcl_${part})
  list(APPEND pcl_libraries ${PCL_${part}_LIBRARY})
endforeach()
if(PCL_REGION_GROWING_INCLUDE AND NOT "${pcl_libraries}" MATCHES "NOTFOUND")
  add_library(scanchor_pcl INTERFACE)
  target_include_directories(scanchor_pcl SYSTEM INTERFACE ${PCL_REGION_GROWING_INCLUDE})
  target_link_libraries(scanchor_pcl INTERFACE ${pcl_libraries})
  target_compile_definitions(scanchor_pcl INTERFACE SCANCHOR_HAVE_PCL=1)
endif()
