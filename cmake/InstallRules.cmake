include(CMakePackageConfigHelpers)
get_property(rooms GLOBAL PROPERTY SCANCHOR_ROOMS)
