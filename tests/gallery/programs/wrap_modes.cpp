// Wrap modes: what lies beyond the edges of a texture, for coordinates from -1 to 2. Repeat,
// mirrored repeat, clamp; clamp to edge, clamp to border; and a texture transformation: the texture
// matrix turns and scales the coordinates.

#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

void wrap_modes(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_TEXTURE_2D);
    texture_2d(chart(16), GL_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const GLfloat orange[] = {1.0f, 0.5f, 0.0f, 1.0f};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, orange);

    const GLint mirrored = scene.broken ? GL_REPEAT : GL_MIRRORED_REPEAT;
    const GLint modes[] = {
        GL_REPEAT, mirrored, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_REPEAT};
    for (int i = 0; i < 6; ++i) {
        enter_in_pixels(panel(scene, i, 3, 2));
        set_wrap(GL_TEXTURE_2D, modes[i]);
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        if (i == 5) {
            glTranslatef(0.5f, 0.5f, 0);
            glRotatef(30, 0, 0, 1);
            glScalef(0.5f, 0.5f, 1);
        }
        glTranslatef(-1, -1, 0);
        draw_rectangle(4, 4, 100, 116, 3); // coordinates from -1 to 2
    }
}

} // namespace ffgpu::gallery
