# Untested: no vcpkg has run this port. VBLAST_SS_SOURCE is an unpacked source archive; a port of a registry downloads it instead.
if(NOT DEFINED ENV{VBLAST_SS_SOURCE})
  message(FATAL_ERROR "Set the environment variable VBLAST_SS_SOURCE to the folder of the sources, and "
                      "VCPKG_KEEP_ENV_VARS to VBLAST_SS_SOURCE.")
endif()
set(SOURCE_PATH "$ENV{VBLAST_SS_SOURCE}")
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" "dynamic" build_shared)
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" "static" build_static)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DVBSS_BUILD_TESTS=OFF -DVBSS_BUILD_EXAMPLES=OFF -DVBSS_BUILD_SHARED=${build_shared} -DVBSS_BUILD_STATIC=${build_static}
          "-DVBSS_REVISION=vcpkg ${VERSION}")
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME vblast_ss CONFIG_PATH lib/cmake/vblast_ss)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
