// A recorder of another build: its own id, and an entry that must not be called.

#include <cstdlib>

extern "C" {

__attribute__((visibility("default"))) const char* ffgpu_recorder_build_id() {
    return "another";
}

__attribute__((visibility("default"))) void* ffgpu_open_recorder(const char*, void*) {
    std::abort();
}
}
