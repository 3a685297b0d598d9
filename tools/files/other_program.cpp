#include "tools/files/other_program.h"

#include <unistd.h>

namespace ffgpu::tools {

void become(const std::vector<std::string>& words) {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (const std::string& word : words)
        pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    ::execvp(pointers[0], pointers.data());
}

} // namespace ffgpu::tools
