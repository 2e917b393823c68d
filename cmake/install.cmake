# cmake --install: the library, its headers and the package behind find_package(boxwood).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/boxwood)

install(TARGETS boxwood EXPORT boxwood-targets)
# What only the library's own sources include, and needs nlohmann_json, fast_float, fmt or assimp,
# which users of the package don't.
install(DIRECTORY src/boxwood DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.h" PATTERN parse_json.h EXCLUDE PATTERN text_scanner.h EXCLUDE
    PATTERN text_chunks.h EXCLUDE PATTERN text_numbers.h EXCLUDE PATTERN plain_triangle.h EXCLUDE
    PATTERN write_lines.h EXCLUDE PATTERN warn_of_vertices.h EXCLUDE PATTERN gltf_materials.h EXCLUDE
    PATTERN assimp EXCLUDE PATTERN gltf EXCLUDE PATTERN obj EXCLUDE PATTERN off EXCLUDE
    PATTERN ply EXCLUDE PATTERN stl EXCLUDE)
install(DIRECTORY schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/boxwood)
install(EXPORT boxwood-targets NAMESPACE boxwood:: DESTINATION ${package_dir})

configure_package_config_file(cmake/boxwood-config.cmake.in ${PROJECT_BINARY_DIR}/boxwood-config.cmake
    INSTALL_DESTINATION ${package_dir})
# Until 1.0 a minor version may break what the one before it promised.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/boxwood-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/boxwood-config.cmake ${PROJECT_BINARY_DIR}/boxwood-config-version.cmake
    DESTINATION ${package_dir})
