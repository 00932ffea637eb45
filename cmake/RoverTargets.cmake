# Compiler settings shared by every target, and helpers to declare libraries and tests.

add_library(rover_options INTERFACE)
# -Wrestrict: GCC 12 reports std::string concatenation falsely (GCC bug 105329); clang has none.
# Contraction to fused multiply-add would make a run's hash depend on the optimiser. Nothing reads
# errno after mathematics, nor the processor's floating-point flags; results stay the same to the bit.
target_compile_options(rover_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    -Wimplicit-fallthrough -Wdouble-promotion $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -ffp-contract=off
    -fno-math-errno -fno-trapping-math
    $<$<BOOL:${ROVER_WERROR}>:-Werror>)
target_include_directories(rover_options INTERFACE "${CMAKE_SOURCE_DIR}")
if(ROVER_SANITIZE)
    target_compile_options(rover_options INTERFACE
        -fsanitize=${ROVER_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
        $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitizer-ignore.txt>)
    target_link_options(rover_options INTERFACE -fsanitize=${ROVER_SANITIZE})
    # The standard library's own checks, of indices above all, come with the sanitizers.
    target_compile_definitions(rover_options INTERFACE _GLIBCXX_ASSERTIONS)
endif()
if(ROVER_BUILD_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        message(FATAL_ERROR "ROVER_BUILD_FUZZ needs clang++ (libFuzzer); use the preset 'fuzz'")
    endif()
    target_compile_options(rover_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# rover_add_library(NAME SOURCES...): a static library with the house settings.
function(rover_add_library name)
    add_library(${name} STATIC ${ARGN})
    target_link_libraries(${name} PRIVATE rover_options)
    target_include_directories(${name} PUBLIC "${CMAKE_SOURCE_DIR}")
endfunction()

# rover_add_test(NAME LABEL SOURCES... LIBS libs...): one GoogleTest program, one ctest entry a test.
function(rover_add_test name)
    cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;LIBS" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE rover_options ${ARG_LIBS} GTest::gtest GTest::gmock)
    target_compile_definitions(${name} PRIVATE
        ROVER_SOURCE_DIR="${CMAKE_SOURCE_DIR}" ROVER_BINARY_DIR="${CMAKE_BINARY_DIR}")
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
        PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT})
endfunction()

# rover_add_gui_test(NAME SOURCES... LIBS libs...): a program that opens windows,
# as one ctest entry on a display of its own.
function(rover_add_gui_test name)
    cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LIBS" ${ARGN})
    add_executable(${name} ${ARG_SOURCES} "${CMAKE_SOURCE_DIR}/tests/support/gui_main.cpp")
    target_link_libraries(${name} PRIVATE
        rover_options ${ARG_LIBS} Qt6::Test Qt6::Widgets GTest::gtest GTest::gmock)
    target_compile_definitions(${name} PRIVATE
        ROVER_SOURCE_DIR="${CMAKE_SOURCE_DIR}" ROVER_BINARY_DIR="${CMAKE_BINARY_DIR}")
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    add_test(NAME ${name} COMMAND xvfb-run -a -s "-screen 0 1920x1200x24" $<TARGET_FILE:${name}>)
    set_tests_properties(${name} PROPERTIES LABELS gui TIMEOUT ${ARG_TIMEOUT})
endfunction()
