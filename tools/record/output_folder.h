// OutputFolder: where the pictures of a run go, made where it is missing. It knows pictures that
// lie there from an older run: they are told of, because nothing else shows which are which.

#pragma once

#include "tools/files/made_folder.h"

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace ffgpu::tools {

class OutputFolder {
public:
    // An empty path: there is none. `prefixes`: of the names of all pictures that such a run may
    // write. Throws InputError where it cannot be made.
    OutputFolder(std::string path, std::span<const std::string_view> prefixes);

    // The path of PREFIX_0000.EXTENSION, which from now on is this run's.
    std::string
    picture(std::string_view prefix, std::uint64_t frame, std::string_view extension = "png");

    // The path of a file, which from now on is this run's.
    std::string file(const std::string& name);

    // One line about the pictures that are none of this run's; empty: there are none.
    std::string older_pictures() const;

private:
    std::string path_;
    MadeFolder made_;
    std::set<std::string> older_; // names
};

} // namespace ffgpu::tools
