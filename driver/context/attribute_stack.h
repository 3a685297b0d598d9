// The attribute stacks of glPushAttrib and glPushClientAttrib (GL 1.5, 6.1.14).

#pragma once

#include "driver/gl_types.h"

#include <memory>
#include <vector>

namespace ffgpu::gl {

class Context;

// What one glPushAttrib saved: driver/context/saved_attributes.h.
struct SavedAttributes;
struct SavedClientAttributes;

class AttributeStack {
public:
    AttributeStack();
    ~AttributeStack();

    unsigned depth() const { return depth_; }
    unsigned client_depth() const { return client_depth_; }

    // False: the stack is full or empty; nothing changes then.
    bool push(Context& context, GLbitfield mask);
    bool pop(Context& context);
    bool push_client(Context& context, GLbitfield mask);
    bool pop_client(Context& context);

private:
    // Entries stay after a pop, so that a program that pushes each frame allocates once.
    std::vector<std::unique_ptr<SavedAttributes>> saved_;
    std::vector<std::unique_ptr<SavedClientAttributes>> saved_client_;
    unsigned depth_ = 0, client_depth_ = 0;
};

} // namespace ffgpu::gl
