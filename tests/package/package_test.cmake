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
    -D CMAKE_CXX_FLAGS=${CXX_FLAGS} -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -D EXAMPLES=${EXAMPLES})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)

function(expect program text)
  run(${WORK_DIR}/build/${program})
  if(NOT output MATCHES "${text}")
    message(FATAL_ERROR "${program} of the outside project printed: ${output}")
  endif()
endfunction()
expect(01_height_field "^7[.]24 m\n")
expect(check_gradient "^exact\n")
expect(02_refine_a_house "^converged ")
expect(04_own_residual "^roof at 7[.]50 m ")
expect(05_refit_planes "^[1-9]+ regularities")

run(${WORK_DIR}/prefix/bin/gable --version)
if(NOT output MATCHES "^gable [0-9]+\\.[0-9]+\\.[0-9]+\n$")
  message(FATAL_ERROR "the installed program printed: ${output}")
endif()
file(REMOVE_RECURSE ${WORK_DIR})
