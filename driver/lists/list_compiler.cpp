#include "driver/lists/list_compiler.h"

#include "driver/objects/shared_objects.h"
#include "driver/vertex/immediate_vertices.h"
#include "driver/vertex/vertex_context.h"

namespace ffgpu::gl {

ListVerticesInPlace::ListVerticesInPlace(VertexContext& context, ListVertices& vertices)
    : context_(context) {
    context.redirect_vertices(vertices);
}

ListVerticesInPlace::~ListVerticesInPlace() {
    context_.redirect_vertices(context_.immediate());
}

void ListCompiler::begin(GLuint name, GLenum mode) {
    list_ = std::make_shared<DisplayList>();
    name_ = name;
    mode_ = mode;
    vertices_.start(*list_);
}

void ListCompiler::end() {
    vertices_.settle();
    list_->code.shrink_to_fit();
    // The name keeps its old list until now: it may have been called from the new one.
    context_.shared().lists.set(name_, std::move(list_));
    list_ = nullptr;
    name_ = 0;
}

} // namespace ffgpu::gl
