# Flint::Flint: FLINT with its ball arithmetic. FLINT 3 contains Arb; beside FLINT 2 Arb is a library
# of its own, named flint-arb by Debian and arb elsewhere. The sources include either layout.
# Installed beside the package configuration, for users of wavecurve::certified.
find_path(FLINT_INCLUDE_DIR flint/fmpq_mat.h)
find_library(FLINT_LIBRARY flint)
find_path(ARB_INCLUDE_DIR NAMES flint/arb.h arb.h)
find_library(ARB_LIBRARY NAMES flint-arb arb)
find_library(GMP_LIBRARY gmp)
find_library(MPFR_LIBRARY mpfr)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  Flint
  REQUIRED_VARS FLINT_LIBRARY FLINT_INCLUDE_DIR ARB_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "FLINT with Arb is needed (Debian: libflint-dev libflint-arb-dev)")
if(Flint_FOUND AND NOT TARGET Flint::Flint)
  add_library(Flint::Flint INTERFACE IMPORTED)
  target_include_directories(Flint::Flint INTERFACE ${FLINT_INCLUDE_DIR} ${ARB_INCLUDE_DIR})
  foreach(library IN ITEMS ARB_LIBRARY FLINT_LIBRARY MPFR_LIBRARY GMP_LIBRARY)
    if(${library})
      target_link_libraries(Flint::Flint INTERFACE ${${library}})
    endif()
  endforeach()
endif()
