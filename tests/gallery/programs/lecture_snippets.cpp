// The lecture's OpenGL snippets, as they stand but for typing errors (a semicolon; glScalef; the
// last matrix is multiplied, not loaded). Left, texturing as printed: the default filter wants mip
// maps that nobody gave, so that OpenGL draws without a texture. Middle, with the two filters set.
// Right, the texture matrix of projective texturing.

#include "tests/gallery/harness/images.h"
#include "tests/gallery/programs/programs.h"

#include <algorithm>

namespace ffgpu::gallery {
namespace {

// NOLINTBEGIN(readability-identifier-naming): the lecture's own names.
constexpr int width = 64, height = 64;

void texturing_snippet(bool with_filters, const Image& image) {
    GLuint mTexId;

    glEnable(GL_TEXTURE_2D);
    // Create texture object
    mTexId = 0;
    glGenTextures(1, &mTexId);

    // Create pixel data and fill it out
    unsigned char* pixels = new unsigned char[width * height * 4];
    std::copy(image.rgba.begin(), image.rgba.end(), pixels);

    // Load pixel data into OpenGL/GPU, 4 bytes/pixel, RGBA
    glBindTexture(GL_TEXTURE_2D, mTexId);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    if (with_filters) { // what the slide leaves out
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }

    // Activate and bind texture to the multi-texture target 0
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, mTexId);

    glBegin(GL_TRIANGLES);
    glTexCoord2f(0, 0);
    glVertex3f(-10, 0, 0);

    glTexCoord2f(1, 0);
    glVertex3f(10, 0, 0);

    glTexCoord2f(0.5, 1);
    glVertex3f(5, 10, 0);
    glEnd();

    // Destroy texture once you are completely done with it.
    glDeleteTextures(1, &mTexId);
    delete[] pixels;
}

void texture_matrix_snippet(bool broken) {
    const GLfloat modelMatrix[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1.5f, 0, 0, 1};
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glTranslatef(0.5, 0.5, 0.5);
    if (!broken) glScalef(0.5, 0.5, 0.5);
    gluPerspective(50, 1, 1, 100);
    gluLookAt(0, -4, 12, 0, 3, 0, 0, 1, 0);
    glMultMatrixf(modelMatrix);
    glMatrixMode(GL_MODELVIEW);
}

void generate_object_coordinates() {
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);

    float planeS[] = {1.0f, 0.0f, 0.0f, 0.0f};
    glTexGenfv(GL_S, GL_OBJECT_PLANE, planeS);

    float planeT[] = {0.0f, 1.0f, 0.0f, 0.0f};
    glTexGenfv(GL_T, GL_OBJECT_PLANE, planeT);

    float planeR[] = {0.0f, 0.0f, 1.0f, 0.0f};
    glTexGenfv(GL_R, GL_OBJECT_PLANE, planeR);

    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    glEnable(GL_TEXTURE_GEN_R);
}

// NOLINTEND(readability-identifier-naming)

} // namespace

void lecture_snippets(const Scene& scene) {
    clear(0.1f, 0.15f, 0.2f);
    for (int i = 0; i < 3; ++i) {
        const Panel place = panel(scene, i, 3, 1);
        enter(place);
        glMatrixMode(GL_PROJECTION);
        gluPerspective(60, place.aspect(), 1, 100);
        glMatrixMode(GL_MODELVIEW);
        gluLookAt(5, -8, 42, 0, 4.5, 0, 0, 1, 0);
        if (i == 2) {
            generate_object_coordinates();
            texture_matrix_snippet(scene.broken);
        }
        texturing_snippet(i > 0, chart(64));
    }
}

} // namespace ffgpu::gallery
