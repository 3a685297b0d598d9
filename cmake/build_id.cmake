# Writes OUTPUT, which defines ffgpu::gl::build_id(): a hash of the files that FILES lists, a path a line.
file(STRINGS ${FILES} files)
set(hashes)
foreach(file ${files})
  file(SHA256 ${file} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 id "${hashes}")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include "driver/window_system/build_id.h"

const char* ffgpu::gl::build_id() {
    return "@id@";
}
]] @ONLY)
