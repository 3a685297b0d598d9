# Writes OUTPUT, which defines ffgpu::tools::asset(): the contents of the files that FILES lists, a
# path a line, each by its name. A line that is empty is a file that is not to be had.
file(STRINGS ${FILES} files)
set(arrays)
set(rows)
set(number 0)
foreach(file ${files})
  cmake_path(GET file FILENAME name)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(APPEND arrays "constexpr unsigned char File${number}[] = {\n${bytes}};\n")
  string(APPEND rows "    {\"${name}\", File${number}, sizeof File${number}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include "tools/page/assets.h"

namespace {

@arrays@
struct File {
    std::string_view name;
    const unsigned char* bytes;
    std::size_t size;
};
constexpr File Files[] = {
@rows@};

} // namespace

std::string_view ffgpu::tools::asset(std::string_view name) {
    for (const File& file : Files)
        if (file.name == name) return {reinterpret_cast<const char*>(file.bytes), file.size};
    return {};
}
]] @ONLY)
