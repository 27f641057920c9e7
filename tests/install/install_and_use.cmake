# cmake -D build=… -D what=headers|suite -P install_and_use.cmake
set(work ${build}/tests/install/${what})
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_FILE ${work}/log ERROR_FILE ${work}/log RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    file(READ ${work}/log log)
    message(FATAL_ERROR "${ARGN}\n${log}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${work})
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/prefix)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/${what} -B ${work}/build -G Ninja -D CMAKE_PREFIX_PATH=${work}/prefix
    -D CMAKE_BUILD_TYPE=${build_type} -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${work}/build)
if(what STREQUAL headers)
  run(${work}/build/user)
else()  # its own integrator, by name, in an arithmetic of ours
  file(WRITE ${work}/euler.toml "question = \"?\"\n[system.rigid_body]\n[integrate]\nmethods = \"explicit-euler\"\nstep = 0.125\nsteps = 8\n[ensemble]\nmembers = 1\n[observe]\nquantities = \"energy\"\n")
  run(${work}/build/user integrate ${work}/euler.toml --arithmetic mpfr-256 --every 8)
  file(STRINGS ${work}/log lines)
  list(LENGTH lines count)
  if(NOT count EQUAL 3)  # a header, the start, the end
    message(FATAL_ERROR "expected 3 lines of csv, found: ${lines}")
  endif()
endif()
