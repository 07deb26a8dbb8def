# isostretch_embed_scenes(<target>) puts the scenes of an app, scenes/*.json, into its program, where they are found by name
# wherever it is installed: embedded_scenes() of common/embedded_scenes.hpp is defined with them. They must name no files.
function(isostretch_embed_scenes target)
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/scenes/*.json)
  set(rows "")
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    cmake_path(GET file STEM name)
    file(READ ${file} text)
    if(text MATCHES "\"(mesh|photo|file)\": *\"")
      message(FATAL_ERROR "${file}: a scene that comes with a program must not name a file, which is not there when it runs")
    endif()
    string(APPEND rows "      {\"${name}\", R\"scene(${text})scene\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/embedded_scenes.cpp @ONLY CONTENT
[[// Made by CMake from scenes/*.json.
#include "common/embedded_scenes.hpp"

namespace isostretch::app {

const std::vector<EmbeddedScene>& embedded_scenes() {
  static const std::vector<EmbeddedScene> scenes{
@rows@  };
  return scenes;
}

}  // namespace isostretch::app
]])
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded_scenes.cpp)
endfunction()
