# Polyclipping::Polyclipping: Clipper 6, which computes what polygons have in common. Installed beside the package
# configuration, for users of wavecurve::io.
find_path(POLYCLIPPING_INCLUDE_DIR polyclipping/clipper.hpp)
find_library(POLYCLIPPING_LIBRARY polyclipping)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  Polyclipping
  REQUIRED_VARS POLYCLIPPING_LIBRARY POLYCLIPPING_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "Clipper is needed (Debian: libpolyclipping-dev)")
if(Polyclipping_FOUND AND NOT TARGET Polyclipping::Polyclipping)
  add_library(Polyclipping::Polyclipping INTERFACE IMPORTED)
  target_include_directories(Polyclipping::Polyclipping INTERFACE ${POLYCLIPPING_INCLUDE_DIR})
  target_link_libraries(Polyclipping::Polyclipping INTERFACE ${POLYCLIPPING_LIBRARY})
endif()
