// A program of the installed library of techniques.
#include <cstdio>

#include <techniques/mapping.h>

int main() {
    const glm::dvec2 uv = ffgpu::techniques::spherical(glm::dvec3(0), {0, 2, 0});
    std::printf("%g %g\n", uv.x, uv.y);
    return uv.x == 0.75 && uv.y == 0.5 ? 0 : 1;
}
