# Is Boxwood of use to another project? Builds and runs tests/consumer with the library installed
# into a scratch prefix, and with the library as a folder of the project.

set(consumer_settings
    -DCMAKE_BUILD_TYPE=Debug
    -DCMAKE_CXX_FLAGS_DEBUG=-O0
    -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS})

function(consumer_test name)
    add_test(NAME package.${name} COMMAND ${CMAKE_CTEST_COMMAND}
        --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${CMAKE_CURRENT_BINARY_DIR}/${name}
        --build-generator ${CMAKE_GENERATOR}
        --build-options ${consumer_settings} ${ARGN}
        --test-command consumer)
endfunction()

set(prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)
add_test(NAME package.install
    COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
consumer_test(find_package -DCMAKE_PREFIX_PATH=${prefix})
# Compiles the whole library, in the way that takes the least time.
consumer_test(add_subdirectory -DBOXWOOD_SOURCE_DIR=${PROJECT_SOURCE_DIR}
    -DBOXWOOD_PRECOMPILED_HEADERS=ON)

set_tests_properties(package.install PROPERTIES FIXTURES_SETUP package)
set_tests_properties(package.find_package PROPERTIES FIXTURES_REQUIRED package)
# It compiles the whole library.
set_tests_properties(package.add_subdirectory PROPERTIES TIMEOUT 600)
