// Grown textures. Left, reaction and diffusion: two substances on a torus, 2000 steps after a few
// drops. Right, a larger texture quilted of random pieces of the left one; along their overlaps the
// pieces are joined by the cut of least error.

#include "techniques/quilting.h"
#include "techniques/reaction_diffusion.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

void grown_textures(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    techniques::Reaction reaction = techniques::seed_reaction(64, 5, 6, 3);
    techniques::advance(reaction, {}, scene.broken ? 1000 : 2000);
    texture_2d(techniques::to_texels(reaction.v, 0, 0.4));
    enter_in_pixels(panel(scene, 0, 2, 1));
    draw_rectangle(16, 56, 144, 184);

    const techniques::Field quilted = techniques::quilt(reaction.v, {23, 8, 8, 60}, 3);
    texture_2d(techniques::to_texels(quilted, 0, 0.4));
    enter_in_pixels(panel(scene, 1, 2, 1));
    draw_rectangle(16, 56, 144, 184);
}

} // namespace ffgpu::gallery
