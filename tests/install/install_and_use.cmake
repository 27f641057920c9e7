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
run(${work}/build/user)
