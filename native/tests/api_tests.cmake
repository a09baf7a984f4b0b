gg_test(api_tests SOURCES api/scene_misuse_test.cpp api/render_misuse_test.cpp api/render_test.cpp api/cancel_test.cpp
        LAYERS core perception image scene material trace transport radiosity film gather render api)

# The library shows nothing but its interface, and its loader's check runs on every x86-64.
add_test(NAME api_exports COMMAND sh -c
  "nm -D --defined-only '$<TARGET_FILE:gridgather>' | awk '$3 !~ /^gg_/ { print; other = 1 } { seen = 1 } END { exit other || !seen }'"
  VERBATIM)
add_test(NAME api_processor_check_is_plain COMMAND sh -c
  "objdump -d --disassemble=gg_processor_supported '$<TARGET_FILE:gridgather>' | awk '/[xyz]mm|\\tv[a-z]/ { print; other = 1 } /ret/ { seen = 1 } END { exit other || !seen }'"
  VERBATIM)
