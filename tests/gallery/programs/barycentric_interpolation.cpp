// Barycentric interpolation: four values across the same triangle. Colours; texture coordinates,
// shown by a texture whose red is u and whose green is v; normals, made unit length by a
// normalisation cube map; and depth, read back and drawn as grey.

#include "techniques/relief.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <vector>

namespace ffgpu::gallery {
namespace {

struct Corner {
    GLfloat place[3], color[3], uv[2], normal[3];
};
const Corner Corners[] = {
    {{15, 12, -0.8f}, {1, 0.1f, 0}, {0.0f, 0.0f}, {-0.8f, -0.5f, 0.4f}},
    {{150, 40, 0.5f}, {0, 0.9f, 0.2f}, {1.0f, 0.2f}, {0.9f, 0.0f, 0.5f}},
    {{60, 112, 0.9f}, {0.1f, 0, 1}, {0.3f, 1.0f}, {0.1f, 0.7f, 0.9f}},
};

// u as red and v as green: 256 texels, so that a bilinear look-up returns the coordinate.
Image coordinates() {
    Image image(256, 256);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x)
            image.set(x, y, x, y, 128);
    }
    return image;
}

void draw_triangle() {
    glBegin(GL_TRIANGLES);
    for (const Corner& corner : Corners) {
        glColor3fv(corner.color);
        glMultiTexCoord2fv(GL_TEXTURE0, corner.uv);
        glMultiTexCoord3fv(GL_TEXTURE1, corner.normal);
        glVertex3fv(corner.place);
    }
    glEnd();
}

void show_depth(const Panel& place) {
    glEnable(GL_DEPTH_TEST);
    draw_triangle();
    std::vector<GLfloat> depth(static_cast<std::size_t>(place.width * place.height));
    glReadPixels(
        place.x, place.y, place.width, place.height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    glDisable(GL_DEPTH_TEST);
    glRasterPos2i(0, 0);
    glDrawPixels(place.width, place.height, GL_LUMINANCE, GL_FLOAT, depth.data());
}

} // namespace

void barycentric_interpolation(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    enter_in_pixels(panel(scene, 0, 2, 2));
    if (scene.broken) glShadeModel(GL_FLAT);
    draw_triangle();
    glShadeModel(GL_SMOOTH);

    enter_in_pixels(panel(scene, 1, 2, 2));
    texture_2d(coordinates());
    set_wrap(GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    draw_triangle();
    glDisable(GL_TEXTURE_2D);

    enter_in_pixels(panel(scene, 2, 2, 2));
    glActiveTexture(GL_TEXTURE1);
    cube_map(techniques::normalisation_cube_map(128));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_CUBE_MAP);
    draw_triangle();
    glDisable(GL_TEXTURE_CUBE_MAP);
    glActiveTexture(GL_TEXTURE0);

    enter_in_pixels(panel(scene, 3, 2, 2));
    show_depth(panel(scene, 3, 2, 2));
}

} // namespace ffgpu::gallery
