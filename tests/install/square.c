/* The ten-line program: a red square into memory. */
#include <ffgpu/osmesa.h>
#include <stdio.h>

int main(void) {
    static unsigned char pixels[64 * 64 * 4];
    OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, NULL);
    if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, 64, 64)) return 1;
    glColor3f(1, 0, 0);
    glRectf(-0.5f, -0.5f, 0.5f, 0.5f);
    glFinish();
    OSMesaDestroyContext(context);
    printf("%d %d\n", pixels[4 * (32 * 64 + 32)], pixels[0]);
    return !(pixels[4 * (32 * 64 + 32)] == 255 && pixels[0] == 0);
}
