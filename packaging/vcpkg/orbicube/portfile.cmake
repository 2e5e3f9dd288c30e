# Port of the tree around it: vcpkg install orbicube --overlay-ports=packaging/vcpkg. All libraries but `tetrahedra`, without the command.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
vcpkg_configure_meson(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -Dcli=disabled -Dtests=false -Dexamples=false -Dtetgen=disabled -Dcholmod=disabled -Dzlib=enabled -Dspng=enabled -Dmeshoptimizer=disabled)
vcpkg_install_meson()
vcpkg_fixup_pkgconfig()
vcpkg_cmake_config_fixup(PACKAGE_NAME orbicube CONFIG_PATH lib/cmake/orbicube)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
