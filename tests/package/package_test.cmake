# Installs gable below a temporary prefix, builds a project outside the tree against it and looks at
# what that prints. Called with -D GABLE_BINARY_DIR, SOURCE_DIR, WORK_DIR, BUILD_TYPE, CXX_FLAGS,
# GENERATOR.
file(REMOVE_RECURSE ${WORK_DIR})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${GABLE_BINARY_DIR} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build -G ${GENERATOR}
    -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix -D CMAKE_BUILD_TYPE=${BUILD_TYPE}
    -D CMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer)
if(NOT output STREQUAL "grammar 5.000\n")
  message(FATAL_ERROR "the installed library printed: ${output}")
endif()
run(${WORK_DIR}/prefix/bin/gable --version)
if(NOT output MATCHES "^gable [0-9]+\\.[0-9]+\\.[0-9]+\n$")
  message(FATAL_ERROR "the installed program printed: ${output}")
endif()
file(REMOVE_RECURSE ${WORK_DIR})
