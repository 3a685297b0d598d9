// Normal mapping by the combiner's dot product. Left, tangent space: each vertex of a plate carries
// the direction of a lamp in its (t, b, m) frame; a normalisation cube map keeps it at unit length
// between the vertices; unit 1 multiplies it with the normal map. Right, object space: the map's
// normals are those of one ball, and the light is a constant.

#include "techniques/relief.h"
#include "tests/gallery/harness/heights.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace ffgpu::gallery {
namespace {

const glm::dvec3 Lamp(0.5, 0.4, 0.7);

void dot_product_with(GLint source) {
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, source);
}

void draw_plate(bool normalised) {
    glActiveTexture(GL_TEXTURE0);
    cube_map(techniques::normalisation_cube_map(64));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    if (normalised) glEnable(GL_TEXTURE_CUBE_MAP);
    glActiveTexture(GL_TEXTURE1);
    texture_2d(techniques::normal_map(hills(64), 7));
    glEnable(GL_TEXTURE_2D);
    dot_product_with(GL_PREVIOUS);

    glBegin(GL_TRIANGLES);
    for (const Triangle& triangle : square(1, 1)) {
        const glm::dmat3 frame =
            techniques::tangent_frame({{{triangle[0].position, triangle[0].uv},
                                        {triangle[1].position, triangle[1].uv},
                                        {triangle[2].position, triangle[2].uv}}},
                                      triangle[0].normal);
        for (const MeshVertex& vertex : triangle) {
            const glm::dvec3 light = glm::transpose(frame) * (Lamp - vertex.position);
            glMultiTexCoord3dv(GL_TEXTURE0, glm::value_ptr(light));
            const glm::dvec3 color = glm::normalize(light) * 0.5 + 0.5;
            glColor3dv(glm::value_ptr(color)); // what is left without the cube map
            glMultiTexCoord2dv(GL_TEXTURE1, glm::value_ptr(vertex.uv));
            glVertex3dv(glm::value_ptr(vertex.position));
        }
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_TEXTURE_CUBE_MAP);
}

// The normals of a ball with dimples, in its own coordinates.
techniques::Texels dimpled_ball() {
    techniques::Texels map{256, 128, 1, 3, {}};
    for (int i = 0; i < 256 * 128; ++i) {
        const double phi = (2 * (i % 256 + 0.5) / 256 - 1) * std::numbers::pi;
        const double theta = (static_cast<int>(i / 256) + 0.5) / 128 * std::numbers::pi;
        const glm::dvec3 around(-std::sin(phi), std::cos(phi), 0);
        const glm::dvec3 down(
            std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi), -std::sin(theta));
        const glm::dvec3 normal = glm::cross(down, around) +
                                  0.4 * std::sin(16 * phi) * std::sin(theta) * around +
                                  0.4 * std::sin(16 * theta) * down;
        const auto texel = techniques::encode_normal(glm::normalize(normal));
        map.bytes.insert(map.bytes.end(), texel.begin(), texel.end());
    }
    return map;
}

void draw_ball() {
    texture_2d(dimpled_ball());
    glEnable(GL_TEXTURE_2D);
    dot_product_with(GL_CONSTANT);
    const GLfloat light[] = {0.5f + 0.5f * 0.36f, 0.5f - 0.5f * 0.8f, 0.5f + 0.5f * 0.48f, 1};
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, light);
    draw_mesh(sphere(1, 96, 48));
    glDisable(GL_TEXTURE_2D);
}

} // namespace

void normal_mapping(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 2; ++i) {
        const Panel place = panel(scene, i, 2, 1);
        enter(place);
        glMatrixMode(GL_PROJECTION);
        gluPerspective(48, place.aspect(), 0.5, 20);
        glMatrixMode(GL_MODELVIEW);
        gluLookAt(0, -2.4, 2.4, 0, 0, 0, 0, 0, 1);
        i == 0 ? draw_plate(!scene.broken) : draw_ball();
    }
}

} // namespace ffgpu::gallery
