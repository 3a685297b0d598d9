// ListCompiler: glNewList ... glEndList (GL 1.5, 5.4).

#pragma once

#include "driver/gl_types.h"
#include "driver/lists/display_list.h"
#include "driver/lists/list_vertices.h"

#include <memory>

namespace ffgpu::gl {

class VertexContext;

class ListCompiler {
public:
    explicit ListCompiler(VertexContext& context)
        : context_(context) {}

    bool compiling() const { return list_ != nullptr; }
    // The commands are carried out as well (GL_COMPILE_AND_EXECUTE).
    bool executing_too() const { return mode_ == GL_COMPILE_AND_EXECUTE; }
    GLuint name() const { return name_; } // of the list being compiled; 0: none
    GLenum mode() const { return list_ ? mode_ : 0; }

    void begin(GLuint name, GLenum mode);
    void end();

    // Where the vertices of the list being compiled go.
    ListVertices& vertices() { return vertices_; }
    // The list's stream, for a record of another command.
    std::vector<std::byte>& code() {
        vertices_.settle();
        return list_->code;
    }

    GLuint base = 0;      // glListBase
    unsigned nesting = 0; // of lists in execution

private:
    VertexContext& context_;
    std::shared_ptr<DisplayList> list_; // being compiled
    GLuint name_ = 0;
    GLenum mode_ = GL_COMPILE;
    ListVertices vertices_;
};

// While it lives, the commands of vertices act on the list that is being compiled.
class ListVerticesInPlace {
public:
    ListVerticesInPlace(VertexContext& context, ListVertices& vertices);
    ~ListVerticesInPlace();
    ListVerticesInPlace(const ListVerticesInPlace&) = delete;
    ListVerticesInPlace& operator=(const ListVerticesInPlace&) = delete;

private:
    VertexContext& context_;
};

} // namespace ffgpu::gl
