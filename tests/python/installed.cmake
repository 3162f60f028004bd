# Installs the CMake component python3 to a temporary prefix, and renders with the installed package. The package must
# not need the build folder. Then installs the component hdf5, and reads an HDF5 file.
#   cmake -D BUILD=... -D SOURCE=... -D PYTHON=... -D FOLDER=lib/python3.x/dist-packages -D HAS_HDF5=... -P installed.cmake
cmake_minimum_required(VERSION 3.25)

set(prefix ${BUILD}/tests/python/prefix)
file(REMOVE_RECURSE ${prefix})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --component python3 --prefix ${prefix}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(file __init__.py py.typed _core.pyi)
  if(NOT EXISTS ${prefix}/${FOLDER}/lippmann/${file} OR IS_SYMLINK ${prefix}/${FOLDER}/lippmann/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
set(ENV{PYTHONPATH} ${prefix}/${FOLDER})
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
execute_process(COMMAND ${PYTHON} -c "import lippmann
assert lippmann.__file__.startswith('${prefix}'), lippmann.__file__
print(lippmann.render('room', lippmann.camera_grid(1, 2, (16, 16))).shape)"
  OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "(1, 2, 16, 16, 3)\n")
  message(FATAL_ERROR "printed: ${output}")
endif()

if(HAS_HDF5 AND FOLDER MATCHES "^lib/[^/]+/dist-packages$")
  set(open "import lippmann; print(lippmann.open('${SOURCE}/tests/formats/files/lf.h5').shape)")
  execute_process(COMMAND ${PYTHON} -c "${open}" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE message)
  if(NOT failed OR NOT message MATCHES "package lippmann-hdf5")
    message(FATAL_ERROR "without the module, the message is: ${message}")
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --component hdf5 --prefix ${prefix}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${PYTHON} -c "${open}" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  if(NOT output STREQUAL "(2, 3, 4, 5, 3)\n")
    message(FATAL_ERROR "printed: ${output}")
  endif()
endif()
