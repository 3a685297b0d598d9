#include "driver/context/context.h"

#include "driver/lists/list_compiler.h"
#include "driver/objects/shared_objects.h"

#include <utility>

namespace ffgpu::gl {

Context::Context(Device& device, std::shared_ptr<SharedObjects> shared)
    : VertexContext(device, std::move(shared))
    , lists_(std::make_unique<ListCompiler>(*this)) {}

Context::~Context() = default;

} // namespace ffgpu::gl
