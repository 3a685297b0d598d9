// OutputFolder: where the pictures of a recording go, made where it is missing. It knows pictures
// that lie there from an older run: they are told of, because nothing else shows which are which.

#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace ffgpu::tools {

class OutputFolder {
public:
    // Empty: there is none. Throws InputError where it cannot be made.
    explicit OutputFolder(std::string path);

    // The path of PREFIX_0000.EXTENSION, which from now on is this run's.
    std::string
    picture(std::string_view prefix, std::uint64_t frame, std::string_view extension = "png");

    // The path of another file.
    std::string file(const std::string& name) const;

    // One line about the pictures that are none of this run's; empty: there are none.
    std::string older_pictures() const;

private:
    std::string path_;
    std::set<std::string> older_; // names
};

} // namespace ffgpu::tools
