# One include form in the tree and after install: #include <gable/grammar/house.h>.
# The build tree gets an include folder whose links point back at the floors.
set(GABLE_INCLUDE_DIR ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${GABLE_INCLUDE_DIR}/gable)
foreach(floor grammar residuals engine training)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${floor} ${GABLE_INCLUDE_DIR}/gable/${floor} SYMBOLIC)
endforeach()

add_library(gable_warnings INTERFACE)
target_compile_options(gable_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                                -Werror)
# GCC 12 sees overlapping copies in every `"literal" + std::string` once it inlines them.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 14)
  target_compile_options(gable_warnings INTERFACE -Wno-restrict)
endif()

# For what computes little and is compiled often, tests and the command line: half the time to
# compile. Warnings that follow values through the code see too little at this level and are wrong.
add_library(gable_glue INTERFACE)
target_compile_options(gable_glue INTERFACE $<$<CONFIG:Release>:-O1>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(gable_glue INTERFACE -Wno-array-bounds -Wno-maybe-uninitialized
                                              -Wno-stringop-overflow -Wno-stringop-overread)
endif()

# gable_layer(<floor> SOURCES ... LINKS ... PRIVATE_LINKS ...): the library of one floor,
# as target gable_<floor> and gable::<floor>.
function(gable_layer floor)
  cmake_parse_arguments(LAYER "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(gable_${floor} ${LAYER_SOURCES})
  add_library(gable::${floor} ALIAS gable_${floor})
  set_target_properties(gable_${floor} PROPERTIES EXPORT_NAME ${floor})
  target_compile_features(gable_${floor} PUBLIC cxx_std_20)
  target_include_directories(gable_${floor} PUBLIC $<BUILD_INTERFACE:${GABLE_INCLUDE_DIR}>
                                                   $<INSTALL_INTERFACE:include>)
  target_link_libraries(gable_${floor} PUBLIC ${LAYER_LINKS}
                        PRIVATE $<BUILD_INTERFACE:gable_warnings> ${LAYER_PRIVATE_LINKS})
endfunction()
