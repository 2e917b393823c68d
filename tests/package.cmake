# Is Boxwood of use to another project? Builds and runs tests/consumer with the library installed
# into a scratch prefix. With the library as a folder of the project it is configured and compiled; to build
# the library once more for that takes minutes, and how it links is what all other tests show.

set(consumer_settings
    -DCMAKE_BUILD_TYPE=Debug
    -DCMAKE_CXX_FLAGS_DEBUG=-O0
    -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS})

# consumer_test(NAME TARGET OPTION...)
function(consumer_test name target)
    set(run "")
    if(target STREQUAL "consumer")
        set(run --test-command consumer)
    endif()
    add_test(NAME package.${name} COMMAND ${CMAKE_CTEST_COMMAND}
        --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${CMAKE_CURRENT_BINARY_DIR}/${name}
        --build-generator ${CMAKE_GENERATOR} --build-target ${target}
        --build-options ${consumer_settings} ${ARGN}
        ${run})
endfunction()

set(prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)
add_test(NAME package.install
    COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
consumer_test(find_package consumer -DCMAKE_PREFIX_PATH=${prefix})
consumer_test(add_subdirectory consumer_main -DBOXWOOD_SOURCE_DIR=${PROJECT_SOURCE_DIR})

set_tests_properties(package.install PROPERTIES FIXTURES_SETUP package)
set_tests_properties(package.find_package PROPERTIES FIXTURES_REQUIRED package)
