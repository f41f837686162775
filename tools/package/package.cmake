# cpack: Debian packages of the program with the library, of the Python package and of what needs MPI, whose dependencies
# are what they are linked with (dpkg-shlibdeps), and an archive of all that may be unpacked anywhere.
set(maintainer "The wavecurve authors <maintainers@wavecurve.example>")
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME wavecurve)
set(CPACK_PACKAGE_VENDOR "The wavecurve authors")
set(CPACK_PACKAGE_CONTACT ${maintainer})
# Each package has a synopsis of its own, the first line of its description.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGE_FILE_NAME wavecurve-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# The charts of the report; and what videos, and programs that use the library, need beside it.
set(CPACK_DEBIAN_MAIN_PACKAGE_DEPENDS "gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_MAIN_PACKAGE_SUGGESTS
    "ffmpeg, libeigen3-dev, libspectra-dev, libboost-dev, libhwy-dev, libfmt-dev, libflint-dev, libflint-arb-dev, libxml2-dev, libpng-dev, zlib1g-dev, libpolyclipping-dev")
set(CPACK_DEBIAN_MAIN_PACKAGE_NAME wavecurve)
set(CPACK_DEBIAN_MAIN_DESCRIPTION
    "certified wavelet operators and a check of published wavelet numerics
Filters, connection coefficients and stiffness operators of periodized
wavelet bases, each number with a proof; solvers of the motion of elastic
curves; wavelet descriptors, morphs and gaits of drawings.
.
The program verifies the tables, figures and claims of a publication of 1996,
and writes a page with the evidence. The C++ library and its headers are
contained.")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_LIBRARY_GROUP main)
set(CPACK_COMPONENT_PROGRAM_GROUP main)
set(CPACK_COMPONENT_PYTHON_GROUP python)
set(CPACK_COMPONENTS_ALL library program)
if(builds_python)
  # The module is for one minor version of Python.
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-wavecurve)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-scipy, python3-pandas")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pywt")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
      "certified wavelet numerics for Python
Filter banks, connection coefficients to any number of proved digits, checks
of published tables, the periodic wavelet transform of numpy arrays, stiffness
operators for scipy, the motion of elastic curves, descriptors and morphs of
drawings.")
endif()
if(TARGET wavecurve_mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
  set(CPACK_COMPONENT_MPI_GROUP mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_NAME wavecurve-mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "wavecurve (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
  set(CPACK_DEBIAN_MPI_PACKAGE_RECOMMENDS "openmpi-bin")
  set(CPACK_DEBIAN_MPI_DESCRIPTION
      "studies of wavelet solvers on many machines
With this, the command compare of the program wavecurve, started by mpirun,
hands the points of its study out to all processes.")
endif()
include(CPack)
