# Installs the package with pip into a new virtual environment, and renders with it from a folder outside of the
# sources. The wheel contains the module of the finished build BUILD. With FROM_SCRATCH, pip builds the module, which takes
# minutes; `scripts/nightly pip` does so.
#   cmake -D BUILD=... -D PYTHON=... -D SOURCE=... -D HAS_HDF5=... [-D FROM_SCRATCH=ON] -P pip.cmake
cmake_minimum_required(VERSION 3.25)

set(folder ${BUILD}/tests/python/pip)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
unset(ENV{PYTHONPATH})
execute_process(COMMAND ${PYTHON} -m venv --system-site-packages ${folder}/venv RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
if(failed)
  message("skipped: ${PYTHON} makes no virtual environment; python3-venv is needed")
  return()
endif()
if(FROM_SCRATCH)
  unset(ENV{LIPPMANN_BUILD})
else()
  set(ENV{LIPPMANN_BUILD} ${BUILD})
endif()
set(ENV{PIP_DISABLE_PIP_VERSION_CHECK} 1)
execute_process(COMMAND ${folder}/venv/bin/pip install --no-index ${SOURCE}
  WORKING_DIRECTORY ${folder} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${folder}/venv/bin/python -c "import lippmann
assert lippmann.__file__.startswith('${folder}'), lippmann.__file__
print(lippmann.render('room', lippmann.camera_grid(1, 2, (16, 16))).shape)"
  WORKING_DIRECTORY ${folder} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "(1, 2, 16, 16, 3)\n")
  message(FATAL_ERROR "printed: ${output}")
endif()
if(HAS_HDF5)
  execute_process(COMMAND ${folder}/venv/bin/python -c "import lippmann
assert lippmann.open('${SOURCE}/tests/formats/files/lf.h5').shape == (2, 3, 4, 5, 3)"
    WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND ${folder}/venv/bin/pip uninstall -y lippmann OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE left ${folder}/venv/lib/*/site-packages/lippmann/*)
if(left)
  message(FATAL_ERROR "pip uninstall leaves: ${left}")
endif()
