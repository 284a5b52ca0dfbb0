# Photographs: by OpenCV and libjpeg-turbo where both are found; without them the program says which packages it needs.
# Debian's CMake files of OpenCV need all of its modules.
find_path(OPENCV_INCLUDE_DIR opencv2/imgproc.hpp PATH_SUFFIXES opencv4)
find_library(OPENCV_CORE_LIBRARY opencv_core)
find_library(OPENCV_IMGPROC_LIBRARY opencv_imgproc)
find_path(TURBOJPEG_INCLUDE_DIR turbojpeg.h)
find_library(TURBOJPEG_LIBRARY turbojpeg)
option(DRYSTONE_PHOTOGRAPHS "Find stones in photographs, where OpenCV and libjpeg-turbo are found" ON)
set(DRYSTONE_HAS_PHOTOGRAPHS OFF)
if(DRYSTONE_PHOTOGRAPHS AND OPENCV_INCLUDE_DIR AND OPENCV_CORE_LIBRARY AND OPENCV_IMGPROC_LIBRARY AND TURBOJPEG_INCLUDE_DIR AND TURBOJPEG_LIBRARY)
    set(DRYSTONE_HAS_PHOTOGRAPHS ON)
endif()
set(DRYSTONE_HAS_PHOTOGRAPHS ${DRYSTONE_HAS_PHOTOGRAPHS} PARENT_SCOPE)

drystone_app_library(photograph
    photograph/stones_command.cpp
    photograph/stones_picture.cpp)
target_link_libraries(drystone_app_photograph PUBLIC drystone_app_drawing drystone_app_output PRIVATE Boost::headers)
if(DRYSTONE_HAS_PHOTOGRAPHS)
    # The headers of OpenCV are compiled once, and its pixels are worth an optimisation.
    drystone_library(app_stones
        photograph/divided_stones.cpp
        photograph/exif_turn.cpp
        photograph/find_photographed.cpp
        photograph/half_way.cpp
        photograph/mortar_maps.cpp
        photograph/read_jpeg.cpp)
    set_target_properties(drystone_app_stones PROPERTIES UNITY_BUILD ON)
    target_compile_options(drystone_app_stones PRIVATE $<$<CONFIG:Release>:-O2> $<$<CONFIG:Debug>:-O1>)
    target_include_directories(drystone_app_stones SYSTEM PRIVATE ${OPENCV_INCLUDE_DIR} ${TURBOJPEG_INCLUDE_DIR})
    target_link_libraries(drystone_app_stones PUBLIC drystone_app_drawing
                          PRIVATE ${OPENCV_IMGPROC_LIBRARY} ${OPENCV_CORE_LIBRARY} ${TURBOJPEG_LIBRARY})
    target_link_libraries(drystone_app_photograph PUBLIC drystone_app_stones)
else()
    target_sources(drystone_app_photograph PRIVATE photograph/no_photographs.cpp)
endif()
