# CMake includes this file at the end of project() of a measured revision. The subjects become a part of that project, so that
# they are compiled with its flags and against its headers. Its targets exist when CMake resolves the names.
add_subdirectory(${CMAKE_CURRENT_LIST_DIR} against)
