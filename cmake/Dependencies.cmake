# Every library that is not ours, each with its reason.
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)             # one worker per core
find_package(fmt 9 REQUIRED)               # g++ 12 has no <format>
find_package(nlohmann_json 3.11 REQUIRED)  # statistics, diagnostics and provenance as data
find_package(CLI11 2 REQUIRED)             # the command line
find_package(OpenEXR 3 REQUIRED)           # the picture file
# Debian 12 installs the config where CMake does not look for it.
find_package(OpenColorIO 2 CONFIG REQUIRED HINTS /usr/share/cmake)  # every colour decision
# From there it derives the include folder /include; the headers stand where every compiler looks.
get_target_property(ocio_include OpenColorIO::OpenColorIO INTERFACE_INCLUDE_DIRECTORIES)
if(ocio_include AND NOT EXISTS "${ocio_include}")
  set_target_properties(OpenColorIO::OpenColorIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "")
endif()
# Debian 12's libdeflate has no config for CMake.
find_path(LIBDEFLATE_INCLUDE_DIR libdeflate.h REQUIRED)
find_library(LIBDEFLATE_LIBRARY deflate REQUIRED)
add_library(libdeflate::libdeflate UNKNOWN IMPORTED)  # compresses the picture file
set_target_properties(libdeflate::libdeflate PROPERTIES
  IMPORTED_LOCATION "${LIBDEFLATE_LIBRARY}"
  INTERFACE_INCLUDE_DIRECTORIES "${LIBDEFLATE_INCLUDE_DIR}")
find_package(PNG REQUIRED)                 # previews and image textures
find_package(JPEG REQUIRED)                # image textures
if(ALHAZEN_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)        # property tests
endif()
