// Displacement mapping: the vertices of a fine ball really move along their normals by the height
// map. Left the ball as it was, right the displaced one: its silhouette changes, and hills hide
// what lies behind them.

#include "techniques/relief.h"
#include "tests/gallery/harness/heights.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

void displacement_mapping(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    texture_2d(chart(128));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    const techniques::Field heights = hills(32);
    Mesh ball = sphere(0.8, 128, 64);
    for (int i = 0; i < 2; ++i) {
        const Panel place = panel(scene, i, 2, 1);
        enter(place);
        glMatrixMode(GL_PROJECTION);
        gluPerspective(50, place.aspect(), 0.5, 20);
        glMatrixMode(GL_MODELVIEW);
        gluLookAt(1.5, -3.5, 1.2, 0, 0, 0, 0, 0, 1);
        draw_mesh(ball);
        const double scale = scene.broken ? 0.3 : 0.45;
        for (Triangle& triangle : ball) {
            for (MeshVertex& vertex : triangle)
                vertex.position = techniques::displaced(
                    {vertex.position, vertex.uv}, vertex.normal, heights, scale);
        }
    }
}

} // namespace ffgpu::gallery
