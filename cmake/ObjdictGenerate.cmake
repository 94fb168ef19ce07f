# objdict_generate(): the object dictionary of a CANopen device as a part of a CMake build.
#
#   include(ObjdictGenerate)
#   objdict_generate(sensor_od DESCRIPTION sensor.eds NODE_ID 5)
#   target_link_libraries(firmware PRIVATE sensor_od)
#
# makes the interface library `sensor_od`: whoever links it compiles the generated sources with its own flags, and finds
# the headers. Several targets may link it. The description is checked and turned into files again when it changes, or
# when a file changes that is read with it (objdict.toml, the file of RENAME, profiles, templates). What comes out the
# same is not written, so nothing is compiled because of it.
#
#   objdict_generate(<name>
#     DESCRIPTION <file>        EDS, DCF, XDD, XDC or the JSON of a device
#     [FOR <target>...]         what `objdict generate --target` knows: c (without FOR), canopennode, concise ...
#     [NODE_ID <1 to 127>] [PREFIX <word>] [MODULE <word>] [NAMES words|index] [RENAME <file>]
#     [CONFIG <file>] [PROFILE <profile>...] [SEVERITY <rule=severity>...]
#     [OPTIONS <argument>...]   further arguments of `objdict generate`
#     [OUT_DIR <folder>]        where the files go; without it, <name> in the current binary folder
#     [OUTPUTS <file>...]       the files below OUT_DIR; without it, objdict is asked for them when CMake configures
#     [DEPENDS <file>...]       further files that the output depends on
#   )
#
# The target `<name>_files` makes the files and nothing else. The list of the files is in the property
# OBJDICT_FILES of the library. OBJDICT_EXECUTABLE is the command; without it, `objdict` is looked for in the PATH.
#
# Generators: Ninja, Makefiles and those of IDEs. CMake 3.20 or newer.

include_guard(GLOBAL)

# The command, as an absolute path.
function(_objdict_find result)
  if(NOT OBJDICT_EXECUTABLE)
    unset(OBJDICT_EXECUTABLE CACHE) # an empty one counts as found
  endif()
  find_program(OBJDICT_EXECUTABLE objdict HINTS ENV CARGO_HOME "$ENV{HOME}/.cargo" PATH_SUFFIXES bin
    DOC "The command objdict; empty: the one in the PATH")
  set(found "${OBJDICT_EXECUTABLE}")
  if(NOT found)
    message(FATAL_ERROR "there is no objdict in the PATH: `cargo install objdict`, or set OBJDICT_EXECUTABLE")
  endif()
  get_filename_component(found "${found}" ABSOLUTE BASE_DIR "${CMAKE_BINARY_DIR}")
  if(NOT EXISTS "${found}")
    message(FATAL_ERROR "OBJDICT_EXECUTABLE is ${found}, and there is no such file")
  endif()
  set(${result} "${found}" PARENT_SCOPE)
endfunction()

# The files that a command of objdict would write.
function(_objdict_list result)
  execute_process(
    COMMAND ${ARGN} --list
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    OUTPUT_VARIABLE files
    ERROR_VARIABLE report
    RESULT_VARIABLE code
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "objdict generates nothing:\n${report}")
  endif()
  string(REPLACE "\n" ";" files "${files}")
  set(${result} "${files}" PARENT_SCOPE)
endfunction()

function(objdict_generate name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DESCRIPTION;NODE_ID;PREFIX;MODULE;NAMES;RENAME;CONFIG;OUT_DIR"
    "FOR;PROFILE;SEVERITY;OPTIONS;OUTPUTS;DEPENDS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "objdict_generate does not know ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_DESCRIPTION)
    message(FATAL_ERROR "objdict_generate needs a DESCRIPTION")
  endif()
  if(NOT arg_FOR)
    set(arg_FOR c)
  endif()
  if(NOT arg_OUT_DIR)
    set(arg_OUT_DIR "${name}")
  endif()
  get_filename_component(out_dir "${arg_OUT_DIR}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  set(depends ${arg_DEPENDS})
  foreach(file DESCRIPTION RENAME CONFIG)
    if(arg_${file})
      get_filename_component(arg_${file} "${arg_${file}}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
      list(APPEND depends "${arg_${file}}")
    endif()
  endforeach()

  _objdict_find(objdict)
  set(command "${objdict}" generate "${arg_DESCRIPTION}" --output "${out_dir}")
  foreach(target IN LISTS arg_FOR)
    list(APPEND command --target "${target}")
  endforeach()
  foreach(option NODE_ID PREFIX MODULE NAMES RENAME CONFIG)
    if(DEFINED arg_${option})
      string(TOLOWER "--${option}" flag)
      string(REPLACE "_" "-" flag "${flag}")
      list(APPEND command "${flag}" "${arg_${option}}")
    endif()
  endforeach()
  foreach(option PROFILE SEVERITY)
    string(TOLOWER "--${option}" flag)
    foreach(value IN LISTS arg_${option})
      list(APPEND command "${flag}" "${value}")
    endforeach()
  endforeach()
  list(APPEND command ${arg_OPTIONS})

  if(arg_OUTPUTS)
    set(files ${arg_OUTPUTS})
    list(TRANSFORM files PREPEND "${out_dir}/")
  else()
    _objdict_list(files ${command})
    # another description may make other files
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${arg_DESCRIPTION}")
  endif()

  # the stamp is always written, the files only when they change
  set(stamp "${CMAKE_CURRENT_BINARY_DIR}/${name}.stamp")
  add_custom_command(
    OUTPUT "${stamp}"
    BYPRODUCTS ${files}
    COMMAND ${command} --stamp "${stamp}" --depfile "${stamp}.d"
    DEPENDS ${depends} "${objdict}"
    DEPFILE "${stamp}.d"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    COMMENT "Generating the object dictionary ${name}"
    VERBATIM)
  add_custom_target(${name}_files DEPENDS "${stamp}")
  set_source_files_properties(${files} PROPERTIES GENERATED TRUE)

  add_library(${name} INTERFACE)
  add_dependencies(${name} ${name}_files)
  target_include_directories(${name} INTERFACE "${out_dir}")
  set(sources ${files})
  list(FILTER sources INCLUDE REGEX "\\.(c|cc|cpp)$")
  target_sources(${name} INTERFACE ${sources})
  set_target_properties(${name} PROPERTIES OBJDICT_FILES "${files}")
endfunction()
