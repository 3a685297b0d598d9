#include "driver/evaluators/bezier.h"
#include "tests/driver/draw_fixture.h"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
namespace entry = ffgpu::gl::entry;
using Value = std::array<float, 4>;

namespace {

// De Casteljau's construction: repeated linear interpolation.
double de_casteljau(std::vector<double> points, double t) {
    while (points.size() > 1) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            points[i] += t * (points[i + 1] - points[i]);
        points.pop_back();
    }
    return points[0];
}

} // namespace

TEST_CASE("curves of every order are what repeated interpolation makes") {
    std::mt19937 random(1);
    for (unsigned order = 1; order <= MaxEvaluatorOrder; ++order) {
        EvaluatorMap map;
        map.u = {static_cast<GLint>(order), -1, 3};
        std::vector<double> points;
        for (unsigned i = 0; i < order; ++i) {
            points.push_back(static_cast<double>(random() % 1000) / 100);
            map.points.push_back(static_cast<float>(points.back()));
        }
        for (const float u : {-1.0f, 0.0f, 1.25f, 3.0f}) {
            const Vec4 value = evaluate(map, 1, bernstein(map.u, u), bernstein(map.v, 0));
            CHECK(static_cast<double>(value[0]) ==
                  Approx(de_casteljau(points, (static_cast<double>(u) + 1) / 4)).epsilon(1e-4));
        }
    }
}

TEST_CASE_METHOD(DrawFixture, "glEvalCoord makes vertices of the enabled maps") {
    const GLfloat points[] = {0, 0, 0, 10, 20, 0};
    const GLfloat colors[] = {0, 0, 0, 1, 1, 1, 1, 1};
    entry::Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, points);
    entry::Map1f(GL_MAP1_COLOR_4, 0, 1, 4, 2, colors);
    entry::Enable(GL_MAP1_VERTEX_3);
    entry::Enable(GL_MAP1_COLOR_4);
    entry::Color3f(0.25f, 0.5f, 0.75f);
    entry::Begin(GL_LINES);
    entry::EvalCoord1f(0.5f);
    entry::Vertex3f(1, 1, 1);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(position(all[0], 0) == Value{5, 10, 0, 1});
    CHECK(attribute(all[0], 0, Attribute::Color) == Value{0.5f, 0.5f, 0.5f, 1});
    // The current colour is not the map's.
    CHECK(attribute(all[0], 1, Attribute::Color) == Value{0.25f, 0.5f, 0.75f, 1});
}

TEST_CASE_METHOD(DrawFixture, "a mesh is strips over the grid, with normals if wanted") {
    // The square [0, 1] x [0, 1] at z = 0.
    const GLfloat points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0};
    entry::Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, points);
    entry::Enable(GL_MAP2_VERTEX_3);
    entry::Enable(GL_AUTO_NORMAL);
    entry::MapGrid2f(4, 0, 1, 2, 0, 1);
    entry::Normal3f(1, 0, 0);
    entry::EvalMesh2(GL_FILL, 0, 4, 0, 2);
    const auto all = draws();
    REQUIRE(all.size() == 2);
    CHECK(all[0].primitive == PrimitiveType::QuadStrip);
    CHECK(all[0].count == 10);
    CHECK(position(all[1], 9) == Value{1, 1, 0, 1});
    CHECK(position(all[0], 2) == Value{0.25f, 0, 0, 1});
    CHECK(attribute(all[0], 3, Attribute::Normal) == Value{0, 0, 1, 1});
    entry::EvalMesh2(GL_LINE, 0, 4, 0, 2);
    CHECK(draws().size() == 8);
    entry::EvalMesh2(GL_POINT, 0, 4, 0, 2);
    CHECK(draws()[0].count == 15);
}

TEST_CASE_METHOD(DrawFixture, "maps are given back as they were set, without gaps") {
    const GLdouble points[] = {1, 2, 3, 99, 4, 5, 6, 99};
    entry::Map1d(GL_MAP1_NORMAL, 2, 6, 4, 2, points);
    GLfloat got[8] = {};
    entry::GetMapfv(GL_MAP1_NORMAL, GL_COEFF, got);
    CHECK(got[3] == 4);
    CHECK(got[5] == 6);
    CHECK(got[6] == 0);
    GLint order[2] = {};
    entry::GetMapiv(GL_MAP1_NORMAL, GL_ORDER, order);
    CHECK(order[0] == 2);
    CHECK(order[1] == 0);
    GLdouble domain[2] = {};
    entry::GetMapdv(GL_MAP1_NORMAL, GL_DOMAIN, domain);
    CHECK(domain[1] == 6);
}

TEST_CASE_METHOD(DrawFixture, "a map and its evaluation may be in a display list") {
    GLfloat points[] = {0, 0, 0, 10, 20, 0};
    entry::NewList(1, GL_COMPILE);
    entry::Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, points);
    entry::Enable(GL_MAP1_VERTEX_3);
    entry::Begin(GL_POINTS);
    entry::Color3f(1, 0, 0);
    entry::EvalCoord1f(1);
    entry::End();
    entry::EndList();
    points[3] = 77;
    entry::CallList(1);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(position(all[0], 0) == Value{10, 20, 0, 1});
    CHECK(attribute(all[0], 0, Attribute::Color) == Value{1, 0, 0, 1});
}

TEST_CASE_METHOD(DrawFixture, "evaluator commands report their errors") {
    const GLfloat points[12] = {};
    entry::Map1f(GL_MAP2_COLOR_4, 0, 1, 4, 2, points);
    CHECK(error() == GL_INVALID_ENUM);
    entry::Map1f(GL_MAP1_COLOR_4, 1, 1, 4, 2, points);
    CHECK(error() == GL_INVALID_VALUE);
    entry::Map1f(GL_MAP1_COLOR_4, 0, 1, 3, 2, points);
    CHECK(error() == GL_INVALID_VALUE);
    entry::Map1f(GL_MAP1_COLOR_4, 0, 1, 4, 0, points);
    CHECK(error() == GL_INVALID_VALUE);
    entry::Map1f(GL_MAP1_COLOR_4, 0, 1, 4, static_cast<GLint>(MaxEvaluatorOrder) + 1, points);
    CHECK(error() == GL_INVALID_VALUE);
    entry::ActiveTexture(GL_TEXTURE1);
    entry::Map1f(GL_MAP1_TEXTURE_COORD_2, 0, 1, 2, 2, points);
    CHECK(error() == GL_INVALID_OPERATION);
    entry::MapGrid1f(0, 0, 1);
    CHECK(error() == GL_INVALID_VALUE);
    entry::EvalMesh1(GL_FILL, 0, 1);
    CHECK(error() == GL_INVALID_ENUM);
}
