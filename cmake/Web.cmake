# The pages: tools/web bundled by npm and esbuild, embedded into carom_report. Without node (18 or later) and npm, or if
# installing fails, a stub page is embedded that shows the figures as a table; everything else still works.

option(CAROM_WEB "Build the pages with node and npm where they are found" ON)

set(carom_web_source ${PROJECT_SOURCE_DIR}/tools/web)
set(carom_web_build ${PROJECT_BINARY_DIR}/web)

# npm ci, only where package-lock.json is not the one installed last. Sets `result` to TRUE if the modules are there.
function(carom_install_node_modules result)
  set(stamp ${carom_web_source}/node_modules/.carom-installed)
  set(${result} TRUE PARENT_SCOPE)
  # All build trees share the modules; where the sources are read-only nothing is installed, and no lock is needed.
  file(LOCK ${carom_web_source} DIRECTORY GUARD FUNCTION TIMEOUT 600 RESULT_VARIABLE ignored)
  file(SHA256 ${carom_web_source}/package-lock.json wanted)
  if(EXISTS ${stamp})
    file(READ ${stamp} installed)
    if(installed STREQUAL wanted)
      return()
    endif()
  endif()
  message(STATUS "Pages: npm ci in tools/web")
  execute_process(COMMAND ${CAROM_NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    WORKING_DIRECTORY ${carom_web_source} TIMEOUT 300 RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE problem)
  if(failed)
    string(STRIP "${problem}" problem)
    message(STATUS "Pages: npm ci failed (${failed}): ${problem}")
    set(${result} FALSE PARENT_SCOPE)
  else()
    file(WRITE ${stamp} ${wanted})
  endif()
endfunction()

# Sets `result` to TRUE if the bundle can be made.
function(carom_find_web result)
  set(${result} FALSE PARENT_SCOPE)
  if(NOT CAROM_WEB)
    message(STATUS "Pages: stub (CAROM_WEB is off)")
    return()
  endif()
  find_program(CAROM_NODE NAMES node nodejs)
  find_program(CAROM_NPM npm)
  if(NOT CAROM_NODE OR NOT CAROM_NPM)
    message(STATUS "Pages: stub, with a table but no charts (install node 18 or later and npm for them)")
    return()
  endif()
  execute_process(COMMAND ${CAROM_NODE} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  string(REGEX REPLACE "^v" "" version "${version}")
  if(version VERSION_LESS 18)
    message(STATUS "Pages: stub, with a table but no charts (node is ${version}, 18 or later is needed)")
    return()
  endif()
  carom_install_node_modules(installed)
  if(NOT installed)
    message(STATUS "Pages: stub, with a table but no charts")
    return()
  endif()
  message(STATUS "Pages: bundled with node ${version}")
  set(${result} TRUE PARENT_SCOPE)
endfunction()

file(MAKE_DIRECTORY ${carom_web_build})
carom_find_web(carom_web_found)
if(carom_web_found)
  set(carom_page ${carom_web_build}/page.html)
  file(GLOB carom_web_files CONFIGURE_DEPENDS ${carom_web_source}/src/*.js ${carom_web_source}/src/*.css ${carom_web_source}/src/*.html)
  add_custom_command(OUTPUT ${carom_page} COMMAND ${CAROM_NODE} ${carom_web_source}/build.mjs --out ${carom_page}
    DEPENDS ${carom_web_files} ${carom_web_source}/build.mjs ${carom_web_source}/package-lock.json VERBATIM COMMENT "Bundling the page")
else()
  set(carom_page ${carom_web_source}/stub.html)
endif()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${carom_web_source}/package-lock.json)

# The page as read-only data. The last section says that the stack need not be executable.
set(carom_page_assembler ${carom_web_build}/page_template.S)
file(CONFIGURE OUTPUT ${carom_page_assembler} @ONLY CONTENT [[
    .section .rodata.carom_page,"a",%progbits
    .globl carom_page_template_begin
    .hidden carom_page_template_begin
    .type carom_page_template_begin, %object
    .globl carom_page_template_end
    .hidden carom_page_template_end
    .type carom_page_template_end, %object
    .balign 16
carom_page_template_begin:
    .incbin "@carom_page@"
carom_page_template_end:
    .byte 0
    .size carom_page_template_begin, carom_page_template_end - carom_page_template_begin
    .size carom_page_template_end, 1
    .section .note.GNU-stack,"",%progbits
]])
set_source_files_properties(${carom_page_assembler} PROPERTIES OBJECT_DEPENDS ${carom_page}
  COMPILE_OPTIONS -Wno-unused-command-line-argument)  # clang names every flag of C++ that an assembler has no use for
target_sources(carom_report PRIVATE ${carom_page_assembler})

if(CAROM_TESTS AND carom_web_found)
  add_test(NAME web COMMAND ${CAROM_NODE} --test ${carom_web_source}/test.mjs)
  set_tests_properties(web PROPERTIES ENVIRONMENT CAROM_PAGE=${carom_page})
endif()
