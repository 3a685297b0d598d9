/* A program that chooses filters of GL_FFGPU_texture_filter, off-screen: the columns of a 64 x 64
 * texture are black and white by turns, and 4 of them meet in a pixel. It prints how far each filter
 * leaves the picture from the grey that they are on average.
 *
 *   cc texture_filter.c $(pkg-config --cflags --libs ffgpu) && ./a.out
 */
#include <ffgpu/ffgpu_texture_filter.h>
#include <ffgpu/osmesa.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { Side = 16, Texels = 64, Grey = 128 };

static unsigned char pixels[Side * Side * 4];

/* The worst pixel's distance from the mean; the texture is moved by a quarter of a texel. */
static int distance(void) {
    int worst = 0, i;
    const float from = 0.25f / Texels;
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_QUADS);
    glTexCoord2f(from, 0), glVertex2i(-1, -1);
    glTexCoord2f(from + 1, 0), glVertex2i(1, -1);
    glTexCoord2f(from + 1, 1), glVertex2i(1, 1);
    glTexCoord2f(from, 1), glVertex2i(-1, 1);
    glEnd();
    glFinish();
    for (i = 0; i < Side * Side; ++i)
        if (abs(pixels[4 * i] - Grey) > worst) worst = abs(pixels[4 * i] - Grey);
    return worst;
}

int main(void) {
    static const struct {
        const char* name;
        GLint value;
    } filters[] = {{"standard", GL_STANDARD_FILTER_FFGPU},
                   {"rip-map", GL_RIP_MAP_FILTER_FFGPU},
                   {"summed-area table", GL_SUMMED_AREA_FILTER_FFGPU},
                   {"elliptic", GL_ELLIPTIC_FILTER_FFGPU},
                   {"Feline", GL_FELINE_FILTER_FFGPU}};
    static unsigned char texels[Texels * Texels];
    int found[5], i;
    OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, NULL);
    if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, Side, Side)) return 1;
    if (!strstr((const char*)glGetString(GL_EXTENSIONS), "GL_FFGPU_texture_filter")) return 1;

    for (i = 0; i < Texels * Texels; ++i)
        texels[i] = i % 2 ? 255 : 0;
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexImage2D(
        GL_TEXTURE_2D, 0, GL_LUMINANCE8, Texels, Texels, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);

    for (i = 0; i < 5; ++i) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, filters[i].value);
        if (i == 3) glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        found[i] = distance();
        printf("%-18s %3d\n", filters[i].name, found[i]);
    }
    i = glGetError() == GL_NO_ERROR;
    OSMesaDestroyContext(context);
    /* Bilinear takes two columns with weights 1/4 and 3/4; all others take the four. */
    return !(i && found[0] > 60 && found[1] <= 1 && found[2] <= 1 && found[3] <= 1 && found[4] <= 1);
}
