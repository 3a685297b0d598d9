#include "driver/lists/list_compiler.h"

#include "driver/context/context.h"
#include "driver/context/limits.h"
#include "driver/lists/player.h"
#include "driver/objects/shared_objects.h"
#include "driver/vertex/immediate_vertices.h"

namespace ffgpu::gl {

namespace {

class NestingLevel {
public:
    explicit NestingLevel(unsigned& depth)
        : depth_(depth) {
        ++depth_;
    }
    ~NestingLevel() { --depth_; }
    NestingLevel(const NestingLevel&) = delete;
    NestingLevel& operator=(const NestingLevel&) = delete;

private:
    unsigned& depth_;
};

} // namespace

ListVerticesInPlace::ListVerticesInPlace(Context& context)
    : context_(context) {
    context.redirect_vertices(context.lists().vertices());
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

void ListCompiler::call(GLuint name) {
    if (depth_ >= MaxListNesting) return;
    const std::shared_ptr<DisplayList> list = context_.shared().lists.share(name);
    if (!list) return;
    const NestingLevel level(depth_);
    play_records(context_, list->code);
}

} // namespace ffgpu::gl
