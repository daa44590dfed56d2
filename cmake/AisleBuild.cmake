# How aisle itself is compiled. Nothing here reaches a project that uses the installed libraries.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set_property(GLOBAL PROPERTY GLOBAL_DEPENDS_NO_CYCLES ON)

find_program(AISLE_CCACHE ccache)
if(AISLE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${AISLE_CCACHE}")
endif()

add_library(aisle_build INTERFACE)

# There are some eighty programs with their tests, and gold links each in a fifth of the usual linker's time.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold AISLE_HAS_GOLD)
target_link_options(aisle_build INTERFACE $<$<BOOL:${AISLE_HAS_GOLD}>:-fuse-ld=gold>)

# The same bits on every machine: one instruction set, no contraction to fused multiply-adds.
target_compile_options(aisle_build INTERFACE -ffp-contract=off)
set(AISLE_INSTRUCTION_SET "${CMAKE_SYSTEM_PROCESSOR}")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(AISLE_INSTRUCTION_SET x86-64-v2)
  target_compile_options(aisle_build INTERFACE -march=${AISLE_INSTRUCTION_SET})
endif()

# Bytes of strangers are read: a fault shall end the program, not serve whoever sent them. tests/hardening checks it.
target_compile_options(aisle_build INTERFACE -fstack-protector-strong)
target_link_options(aisle_build INTERFACE -Wl,-z,relro,-z,now)
if(NOT AISLE_SANITIZE)
  target_compile_options(aisle_build INTERFACE $<$<CONFIG:Release>:-U_FORTIFY_SOURCE> $<$<CONFIG:Release>:-D_FORTIFY_SOURCE=2>)
endif()

if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_VERIFY_INTERFACE_HEADER_SETS ON)
  target_compile_options(aisle_build INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
    -Wno-missing-field-initializers -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 reports overlaps inside std::string's operator+ that cannot happen (GCC bug 105651).
    # It takes the alternatives of a std::variant that is moved for uninitialised (GCC bug 80635); clang checks.
    target_compile_options(aisle_build INTERFACE -Wno-restrict -Wno-maybe-uninitialized)
  endif()
endif()

set(AISLE_SANITIZE "" CACHE STRING "Sanitizers to compile with, e.g. address,undefined")
if(AISLE_SANITIZE)
  target_compile_options(aisle_build INTERFACE -fsanitize=${AISLE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(aisle_build INTERFACE -fsanitize=${AISLE_SANITIZE})
  # Among a sanitizer's own instructions GCC 12 sees overflows and overlaps that are not there.
  target_compile_options(aisle_build INTERFACE -Wno-error)
  # What is undefined traps, and the address sanitizer says where: the calls that would say what take a third of the
  # compiler's time.
  if(AISLE_SANITIZE MATCHES "undefined" AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(aisle_build INTERFACE -fsanitize-trap=undefined)
  endif()
endif()

# Tests are read by the compiler far longer than they run.
add_library(aisle_test_build INTERFACE)
target_compile_options(aisle_test_build INTERFACE $<$<NOT:$<CONFIG:Debug>>:-O1>)
