// 3-D textures. Left, a ball carved out of marble: the texture coordinates are the place itself.
// Right, a volume: slices of a 3-D texture from back to front, each blended over what lies behind.

#include "techniques/noise.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

using namespace techniques;

constexpr int Size = 64, Slices = 48;

// The centre of a texel in a cube from -1 to 1.
glm::dvec3 place_of(int i) {
    return (glm::dvec3(i % Size, i / Size % Size, static_cast<int>(i / Size / Size)) + 0.5) *
               (2.0 / Size) -
           1.0;
}

Texels marble() {
    const GradientNoise noise(4);
    const Stripes stripes{{0.6, 0, 0.8}, 0.7, 2.5, 2};
    Texels texels{Size, Size, Size, 3, {}};
    for (int i = 0; i < Size * Size * Size; ++i) {
        const double vein = stripe(stripes, noise, 1.5 * place_of(i));
        for (const double dark : {0.25, 0.35, 0.3})
            texels.bytes.push_back(to_byte(0.95 - (0.95 - dark) * vein * vein));
    }
    return texels;
}

// Two clouds, one warm and one cold; alpha is how much a slice hides.
Texels clouds() {
    Texels texels{Size, Size, Size, 4, {}};
    for (int i = 0; i < Size * Size * Size; ++i) {
        const glm::dvec3 p = place_of(i), a = p - glm::dvec3(0.25, 0.1, 0.2),
                         b = p + glm::dvec3(0.3, 0.15, 0.1);
        const double warm = std::exp(-9 * glm::dot(a, a)), cold = std::exp(-14 * glm::dot(b, b));
        const double sum = warm + cold + 1e-9;
        texels.bytes.push_back(to_byte((warm + 0.2 * cold) / sum));
        texels.bytes.push_back(to_byte((0.5 * warm + 0.5 * cold) / sum));
        texels.bytes.push_back(to_byte((0.1 * warm + cold) / sum));
        texels.bytes.push_back(to_byte(0.3 * std::min(1.0, sum)));
    }
    return texels;
}

// (s, t, r) = the place, the cube from -1 to 1 becoming [0, 1]; the texture's box is turned by
// `angle`.
void fill_box(float angle) {
    coordinates_are_places();
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glTranslatef(0.5f, 0.5f, 0.5f);
    glScalef(0.5f, 0.5f, 0.5f);
    glRotatef(angle, 0, 1, 0);
}

void look(const Panel& place) {
    enter(place);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(38, place.aspect(), 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -4.5f);
}

void draw_slices(int count) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < count; ++i) {
        glPushMatrix();
        glTranslatef(0, 0, 2 * (static_cast<float>(i) + 0.5f) / Slices - 1);
        // The generated coordinates are of the object, which the matrix has not moved.
        const GLfloat plane[] = {0, 0, 0, 2 * (static_cast<float>(i) + 0.5f) / Slices - 1};
        glTexGenfv(GL_R, GL_OBJECT_PLANE, plane);
        glRectf(-1, -1, 1, 1);
        glPopMatrix();
    }
    glDisable(GL_BLEND);
}

} // namespace

void solid_textures(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_TEXTURE_3D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    texture_3d(marble());
    set_wrap(GL_TEXTURE_3D, GL_CLAMP_TO_EDGE);
    fill_box(0);
    look(panel(scene, 0, 2, 1));
    glEnable(GL_DEPTH_TEST);
    draw_mesh(sphere(0.97, 96, 48));
    glDisable(GL_DEPTH_TEST);

    texture_3d(clouds());
    set_wrap(GL_TEXTURE_3D, GL_CLAMP_TO_EDGE);
    fill_box(35);
    look(panel(scene, 1, 2, 1));
    draw_slices(scene.broken ? Slices / 2 : Slices);
}

} // namespace ffgpu::gallery
