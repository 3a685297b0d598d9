// Context: one GL rendering context, as the commands see it. It is made of layers, each of which is
// all that the folders of its height know: DeviceContext (state, registers, device), VertexContext
// (vertices to draws), and here what only commands need. The GL commands themselves are the
// functions of ffgpu::gl::api (driver/api/, a file a chapter).

#pragma once

#include "driver/context/attribute_stack.h"
#include "driver/objects/name_table.h"
#include "driver/vertex/vertex_context.h"

#include <functional>
#include <memory>

namespace ffgpu::gl {

class ListCompiler; // driver/lists/list_compiler.h

class Context : public VertexContext {
public:
    // `shared` may be another context's (glXCreateContext's share list). The context is not
    // bound to a drawable yet; see make_current in driver/context/current.h.
    Context(Device& device, std::shared_ptr<SharedObjects> shared);
    ~Context();

    bool was_bound = false; // to a drawable: viewport and scissor have their initial values.
    AttributeStack attributes;
    // The window system's: shows what was drawn to a front buffer, at glFlush and glFinish.
    std::function<void()> on_flush;

    // Vertex array objects are not shared. Name 0 is an object, too.
    NameTable<VertexArrayObject> vertex_array_objects;
    const std::shared_ptr<VertexArrayObject> default_vertex_array_object = client.arrays.object;

    ListCompiler& lists() { return *lists_; }

private:
    std::unique_ptr<ListCompiler> lists_;
};

} // namespace ffgpu::gl
