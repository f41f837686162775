# Other libraries that ours is tested against and measured beside, never used by it. None is required: one that
# is missing, or cannot be compiled with, is named in one line, and what needs it is left out.
#   peers::gsl        GSL's wavelets, with the definition WAVECURVE_GSL
#   peers::sundials   CVODE and ARKODE, versions 6 and 7, with the definition WAVECURVE_SUNDIALS
find_package(GSL QUIET)
if(GSL_FOUND)
  add_library(peers_gsl INTERFACE)
  add_library(peers::gsl ALIAS peers_gsl)
  target_link_libraries(peers_gsl INTERFACE GSL::gsl GSL::gslcblas)
  target_compile_definitions(peers_gsl INTERFACE WAVECURVE_GSL)
else()
  message(STATUS "No GSL: its tables and transforms are neither tested nor measured against")
endif()

# By files, not by SUNDIALSConfig.cmake: where a distribution builds SUNDIALS with MPI that demands targets
# for C, and its component names differ between versions.
find_path(SUNDIALS_INCLUDE_DIR cvode/cvode.h)
set(sundials_libraries)
foreach(name IN ITEMS cvode arkode nvecserial sunlinsolspgmr sunnonlinsolfixedpoint core)
  find_library(SUNDIALS_${name}_LIBRARY sundials_${name})
  if(SUNDIALS_${name}_LIBRARY)
    list(APPEND sundials_libraries ${SUNDIALS_${name}_LIBRARY})
  endif()
endforeach()
set(sundials_includes ${SUNDIALS_INCLUDE_DIR})
if(SUNDIALS_INCLUDE_DIR AND SUNDIALS_cvode_LIBRARY AND NOT DEFINED WAVECURVE_SUNDIALS_COMPILES)
  find_package(MPI QUIET COMPONENTS CXX)
  if(MPI_CXX_FOUND)  # whose header SUNDIALS 7 includes where it was built with it
    list(APPEND sundials_includes ${MPI_CXX_INCLUDE_DIRS})
    list(APPEND sundials_libraries ${MPI_CXX_LIBRARIES})
  endif()
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_INCLUDES ${sundials_includes})
  set(CMAKE_REQUIRED_LIBRARIES ${sundials_libraries})
  check_cxx_source_compiles("
    #include <arkode/arkode_erkstep.h>
    #include <cvode/cvode.h>
    #include <nvector/nvector_serial.h>
    int main() {
      SUNContext context = nullptr;
      void* memory = CVodeCreate(CV_BDF, context);
      return memory == ERKStepCreate(nullptr, 0, N_VNew_Serial(1, context), context);
    }" WAVECURVE_SUNDIALS_COMPILES)
  unset(CMAKE_REQUIRED_INCLUDES)
  unset(CMAKE_REQUIRED_LIBRARIES)
  set(WAVECURVE_SUNDIALS_INCLUDES ${sundials_includes} CACHE INTERNAL "with MPI's, where that is needed")
  set(WAVECURVE_SUNDIALS_LIBRARIES ${sundials_libraries} CACHE INTERNAL "with MPI's, where that is needed")
endif()
if(WAVECURVE_SUNDIALS_COMPILES)
  add_library(peers_sundials INTERFACE)
  add_library(peers::sundials ALIAS peers_sundials)
  target_include_directories(peers_sundials SYSTEM INTERFACE ${WAVECURVE_SUNDIALS_INCLUDES})
  target_link_libraries(peers_sundials INTERFACE ${WAVECURVE_SUNDIALS_LIBRARIES})
  target_compile_definitions(peers_sundials INTERFACE WAVECURVE_SUNDIALS)
else()
  message(STATUS "No SUNDIALS that compiles: its integrators are not measured")
endif()
