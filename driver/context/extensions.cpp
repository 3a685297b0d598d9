#include "driver/context/extensions.h"

#include <string>

namespace ffgpu::gl {

const char* extension_string() {
    static const std::string names = [] {
        std::string all;
        for (const std::string_view name : Extensions) {
            all += name;
            all += ' ';
        }
        return all;
    }();
    return names.c_str();
}

} // namespace ffgpu::gl
