# Every layer's sources and what it may use. A test holds the #include lines against these arrows.
gg_layer(core SOURCES control.cpp distance.cpp messages.cpp parallel.cpp statistics.cpp LINKS TBB::tbb glm::glm)
set(gg_layers gg_core)
# Further layers, lowest first; each lists its own sources.
foreach(layer perception image scene material trace transport radiosity film gather render api)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${layer}/layer.cmake)
    include(${layer}/layer.cmake)
    list(APPEND gg_layers gg_${layer})
  endif()
endforeach()
