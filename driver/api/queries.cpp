// Occlusion queries (GL 1.5, 4.1.7 and 6.1.12).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/limits.h"
#include "driver/objects/shared_objects.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <span>

namespace ffgpu::gl::api {
namespace {

constexpr std::uint64_t ResultBytes = 8;

void submit(Context& context, Opcode opcode, std::initializer_list<std::uint32_t> payload = {}) {
    CommandStream commands;
    commands.add(opcode, payload);
    context.submit(commands);
}

std::uint64_t read_result(Context& context, const QueryObject& query) {
    std::array<std::byte, ResultBytes> bytes;
    context.device().read_memory(query.result.address(), bytes);
    std::uint64_t samples = 0;
    for (std::size_t i = ResultBytes; i-- > 0;)
        samples = samples << 8 | std::to_integer<std::uint64_t>(bytes[i]);
    return samples;
}

template <class Integer>
void get_query_object(Context& context, GLuint id, GLenum pname, Integer* params) {
    const QueryObject* const query = context.queries.names.find(id);
    if (!query || id == context.queries.active) return context.error(GL_INVALID_OPERATION);
    switch (pname) {
    case GL_QUERY_RESULT: {
        constexpr std::uint64_t Max = std::numeric_limits<Integer>::max();
        *params = static_cast<Integer>(std::min(read_result(context, *query), Max));
        break;
    }
    case GL_QUERY_RESULT_AVAILABLE: // Reading waits for the device itself.
        *params = GL_TRUE;
        break;
    default:
        context.error(GL_INVALID_ENUM);
    }
}

} // namespace

// GL 1.5 refuses new and deleted names while any query is active; later versions do not, and
// programs rely on it: a deleted query that is active ends, without a result.
void GenQueries(Context& context, GLsizei n, GLuint* ids) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    context.queries.names.generate(std::span(ids, static_cast<std::size_t>(n)));
}

void DeleteQueries(Context& context, GLsizei n, const GLuint* ids) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    for (const GLuint id : std::span(ids, static_cast<std::size_t>(n))) {
        if (id != 0 && id == context.queries.active) {
            context.queries.active = 0;
            context.dirty.mark(Dirty::Fragment);
        }
        context.queries.names.remove(id);
    }
}

GLboolean IsQuery(Context& context, GLuint id) {
    return context.queries.names.find(id) ? GL_TRUE : GL_FALSE;
}

void BeginQuery(Context& context, GLenum target, GLuint id) {
    if (target != GL_SAMPLES_PASSED) return context.error(GL_INVALID_ENUM);
    QueryObjects& queries = context.queries;
    if (queries.active != 0 || id == 0) return context.error(GL_INVALID_OPERATION);
    if (!queries.names.find(id)) {
        auto query = std::make_shared<QueryObject>();
        query->result = DeviceBlock::allocate(context.shared().memory, ResultBytes);
        if (!query->result) return context.error(GL_OUT_OF_MEMORY);
        queries.names.set(id, std::move(query));
    }
    queries.active = id;
    submit(context, Opcode::ResetSampleCounter);
    context.dirty.mark(Dirty::Fragment);
}

void EndQuery(Context& context, GLenum target) {
    if (target != GL_SAMPLES_PASSED) return context.error(GL_INVALID_ENUM);
    QueryObjects& queries = context.queries;
    if (queries.active == 0) return context.error(GL_INVALID_OPERATION);
    const DeviceAddress result = queries.names.find(queries.active)->result.address();
    submit(context, Opcode::StoreSampleCounter, {result});
    queries.active = 0;
    context.dirty.mark(Dirty::Fragment);
}

void GetQueryiv(Context& context, GLenum target, GLenum pname, GLint* params) {
    if (target != GL_SAMPLES_PASSED) return context.error(GL_INVALID_ENUM);
    switch (pname) {
    case GL_CURRENT_QUERY:
        *params = static_cast<GLint>(context.queries.active);
        break;
    case GL_QUERY_COUNTER_BITS:
        *params = QueryCounterBits;
        break;
    default:
        context.error(GL_INVALID_ENUM);
    }
}

void GetQueryObjectiv(Context& context, GLuint id, GLenum pname, GLint* params) {
    get_query_object(context, id, pname, params);
}

void GetQueryObjectuiv(Context& context, GLuint id, GLenum pname, GLuint* params) {
    get_query_object(context, id, pname, params);
}

} // namespace ffgpu::gl::api
