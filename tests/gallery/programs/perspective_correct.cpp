// Perspective-correct interpolation. Above: the hardware's, which interpolates (u/w, v/w) and 1/w;
// and affine, the same corners projected beforehand and drawn with w = 1. Below: affine again on
// refined meshes, even on the left; on the right the two halves of the floor differ in refinement,
// so that the texture tears along their T-junctions.

#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <cmath>

namespace ffgpu::gallery {
namespace {

constexpr double FieldOfView = 45, Rise = 0.6, Near = 0.5, Far = 50;

// A rectangle of the floor y = -1.
struct Floor {
    double left, right, front, back; // x, and z in front of the eye
};
const Floor Whole{-2, 2, 1.6, 9};

// Texture coordinates: [0, 1] over the whole floor.
void corner(double x, double z, const Panel* projected_for) {
    glTexCoord2d((x + 2) / 4, (z - 1.6) / 7.4);
    if (!projected_for) {
        glVertex3d(x, -1, -z);
        return;
    }
    const double focal = 1 / std::tan(FieldOfView / 2 * 3.14159265358979 / 180);
    glVertex2d(x * focal / projected_for->aspect() / z, -1 * focal / z + Rise);
}

// As columns x rows cells of two triangles each; affine if a panel is given.
void draw_floor(const Floor& floor, int columns, int rows, const Panel* affine) {
    const double width = (floor.right - floor.left) / columns;
    const double depth = (floor.back - floor.front) / rows;
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < columns * rows; ++i) {
        const double x0 = floor.left + i % columns * width, x1 = x0 + width;
        const double z0 = floor.front + i / columns * depth, z1 = z0 + depth;
        corner(x0, z0, affine);
        corner(x1, z0, affine);
        corner(x1, z1, affine);
        corner(x0, z0, affine);
        corner(x1, z1, affine);
        corner(x0, z1, affine);
    }
    glEnd();
}

} // namespace

void perspective_correct(const Scene& scene) {
    clear(0.45f, 0.6f, 0.8f);
    glEnable(GL_TEXTURE_2D);
    texture_2d(checker(8, 8), GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    const Panel first = panel(scene, 0, 2, 2);
    enter(first);
    if (scene.broken) {
        draw_floor(Whole, 1, 1, &first);
    } else {
        glMatrixMode(GL_PROJECTION);
        glTranslated(0, Rise, 0); // the lens is shifted, so that the floor fills the picture
        gluPerspective(FieldOfView, first.aspect(), Near, Far);
        draw_floor(Whole, 1, 1, nullptr);
    }
    enter(panel(scene, 1, 2, 2));
    draw_floor(Whole, 1, 1, &first);
    enter(panel(scene, 2, 2, 2));
    draw_floor(Whole, 6, 6, &first);
    enter(panel(scene, 3, 2, 2));
    draw_floor({-2, 0, 1.6, 9}, 1, 2, &first);
    draw_floor({0, 2, 1.6, 9}, 3, 6, &first);
}

} // namespace ffgpu::gallery
