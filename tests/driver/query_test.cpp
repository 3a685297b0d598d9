// Occlusion queries.

#include "tests/driver/state_fixture.h"

#include <cstring>

#include <catch2/catch.hpp>

namespace ffgpu::gl {
namespace {

using namespace entry;

GLuint make_query() {
    GLuint id = 0;
    GenQueries(1, &id);
    return id;
}

GLuint get_result(GLuint id) {
    GLuint result = 0xdeadbeef;
    GetQueryObjectuiv(id, GL_QUERY_RESULT, &result);
    return result;
}

// The device counts: here the test does, in the place that the driver gave.
void store_result(StateFixture& f, std::uint64_t samples) {
    REQUIRE(f.device.commands.back().opcode == Opcode::StoreSampleCounter);
    std::memcpy(
        f.device.memory.data() + f.device.commands.back().payload[0], &samples, sizeof samples);
}

} // namespace

TEST_CASE("A query resets the counter, counts while it is active, and stores it") {
    StateFixture f;
    const GLuint id = make_query();
    f.device.forget();
    BeginQuery(GL_SAMPLES_PASSED, id);
    CHECK(f.device.commands.back().opcode == Opcode::ResetSampleCounter);
    CHECK(f.drawn().fragment.count_samples);
    EndQuery(GL_SAMPLES_PASSED);
    store_result(f, 1234);
    CHECK(!f.drawn().fragment.count_samples);
    CHECK(get_result(id) == 1234);
    GLint available = 0;
    GetQueryObjectiv(id, GL_QUERY_RESULT_AVAILABLE, &available);
    CHECK(available == GL_TRUE);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("A count too large for the type reads as its largest value") {
    StateFixture f;
    const GLuint id = make_query();
    BeginQuery(GL_SAMPLES_PASSED, id);
    EndQuery(GL_SAMPLES_PASSED);
    store_result(f, std::uint64_t{1} << 40);
    CHECK(get_result(id) == 0xffffffffu);
    GLint result = 0;
    GetQueryObjectiv(id, GL_QUERY_RESULT, &result);
    CHECK(result == 0x7fffffff);
}

TEST_CASE("A name is a query object from its first use on") {
    StateFixture f;
    const GLuint id = make_query();
    CHECK(IsQuery(id) == GL_FALSE);
    BeginQuery(GL_SAMPLES_PASSED, id);
    CHECK(IsQuery(id) == GL_TRUE);
    GLint current = 0, bits = 0;
    GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
    GetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
    CHECK(static_cast<GLuint>(current) == id);
    CHECK(bits >= 32);
    EndQuery(GL_SAMPLES_PASSED);
    GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
    CHECK(current == 0);
    DeleteQueries(1, &id);
    CHECK(IsQuery(id) == GL_FALSE);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("Deleted queries give their device memory back") {
    StateFixture f;
    const std::uint64_t before = f.gl.shared()->memory->bytes_in_use();
    const GLuint id = make_query();
    BeginQuery(GL_SAMPLES_PASSED, id);
    EndQuery(GL_SAMPLES_PASSED);
    CHECK(f.gl.shared()->memory->bytes_in_use() > before);
    DeleteQueries(1, &id);
    CHECK(f.gl.shared()->memory->bytes_in_use() == before);
}

TEST_CASE("Query commands out of order are refused") {
    StateFixture f;
    const GLuint id = make_query(), other = make_query();
    GLuint result = 5;
    BeginQuery(GL_TEXTURE_2D, id);
    CHECK(GetError() == GL_INVALID_ENUM);
    BeginQuery(GL_SAMPLES_PASSED, 0);
    CHECK(GetError() == GL_INVALID_OPERATION);
    EndQuery(GL_SAMPLES_PASSED);
    CHECK(GetError() == GL_INVALID_OPERATION);
    GetQueryObjectuiv(id, GL_QUERY_RESULT, &result);
    CHECK(GetError() == GL_INVALID_OPERATION);
    BeginQuery(GL_SAMPLES_PASSED, id);
    CHECK(GetError() == GL_NO_ERROR);
    BeginQuery(GL_SAMPLES_PASSED, other);
    CHECK(GetError() == GL_INVALID_OPERATION);
    GetQueryObjectuiv(id, GL_QUERY_RESULT, &result);
    CHECK(GetError() == GL_INVALID_OPERATION);
    DeleteQueries(1, &other); // Not the active one.
    GLuint fresh = 0;
    GenQueries(1, &fresh);
    CHECK(GetError() == GL_NO_ERROR);
    EndQuery(GL_SAMPLES_PASSED);
    GetQueryObjectuiv(id, GL_TEXTURE, &result);
    CHECK(GetError() == GL_INVALID_ENUM);
    GenQueries(-1, &result);
    CHECK(GetError() == GL_INVALID_VALUE);
    CHECK(result == 5);
}

TEST_CASE("An active query that is deleted has ended") {
    StateFixture f;
    const GLuint id = make_query(), other = make_query();
    BeginQuery(GL_SAMPLES_PASSED, id);
    DeleteQueries(1, &id);
    CHECK(GetError() == GL_NO_ERROR);
    CHECK(!f.drawn().fragment.count_samples);
    EndQuery(GL_SAMPLES_PASSED);
    CHECK(GetError() == GL_INVALID_OPERATION);
    BeginQuery(GL_SAMPLES_PASSED, other);
    CHECK(GetError() == GL_NO_ERROR);
    EndQuery(GL_SAMPLES_PASSED);
}

} // namespace ffgpu::gl
