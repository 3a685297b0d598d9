// InputError: a file, an option or a configuration is wrong. The text is one line that names the
// thing, where in it, and what was expected. main() prints it and exits with status 2.

#pragma once

#include <stdexcept>

namespace ffgpu {

class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// OutputError: a file cannot be written. Nobody goes on behind it, as one may behind an input that
// is wrong.
class OutputError : public InputError {
public:
    using InputError::InputError;
};

} // namespace ffgpu
