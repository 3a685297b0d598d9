// A room with light maps as a second texture, fog, alpha-blended glass and an alpha-tested grille:
// multitexture, vertex arrays, combine. 320x240, 6 frames.

#define GL_GLEXT_PROTOTYPES
#include "window.h"

namespace {

using namespace demo;

struct Vertex {
    float s0, t0, s1, t1;
    float x, y, z;
};

std::vector<Vertex> room;
GLuint stone, light_map, grille;

// A subdivided rectangle: corner + u * across + v * up, base texture repeated `repeat` times.
void add_panel(const float corner[3], const float across[3], const float up[3], float repeat) {
    constexpr int N = 6;
    const auto vertex = [&](int i, int j) {
        const float u = static_cast<float>(i) / N, v = static_cast<float>(j) / N;
        room.push_back({u * repeat,
                        v * repeat,
                        u,
                        v,
                        corner[0] + u * across[0] + v * up[0],
                        corner[1] + u * across[1] + v * up[1],
                        corner[2] + u * across[2] + v * up[2]});
    };
    for (int j = 0; j < N; ++j) {
        for (int i = 0; i < N; ++i) {
            vertex(i, j);
            vertex(i + 1, j);
            vertex(i + 1, j + 1);
            vertex(i, j + 1);
        }
    }
}

Image stone_image() {
    return paint(128, [](int x, int y) {
        const float level = 0.45f + 0.3f * hash(x / 16, y / 16) + 0.2f * hash(x, y);
        const bool joint = x % 32 < 2 || y % 32 < 2;
        return joint ? Rgb{0.2f, 0.2f, 0.22f} : Rgb{level, level * 0.95f, level * 0.85f};
    });
}

Image light_image() {
    return paint(32, [](int x, int y) {
        const float dx = (static_cast<float>(x) - 10.0f) / 12.0f,
                    dy = (static_cast<float>(y) - 20.0f) / 12.0f;
        const float pool = std::exp(-(dx * dx + dy * dy));
        return Rgb{0.25f + pool, 0.22f + 0.8f * pool, 0.3f + 0.5f * pool};
    });
}

void make_grille() {
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const bool bar = x % 16 < 4 || y % 16 < 4;
            texels.push_back(bar ? 200 : 0);
            texels.push_back(bar ? 255 : 0);
        }
    }
    glGenTextures(1, &grille);
    glBindTexture(GL_TEXTURE_2D, grille);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexImage2D(GL_TEXTURE_2D,
                 0,
                 GL_LUMINANCE_ALPHA,
                 64,
                 64,
                 0,
                 GL_LUMINANCE_ALPHA,
                 GL_UNSIGNED_BYTE,
                 texels.data());
}

void setup() {
    stone = make_texture(stone_image());
    light_map = make_texture(light_image(), false);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    make_grille();

    const float left[] = {-3, -1.5f, 0}, right[] = {3, -1.5f, -12}, across[] = {6, 0, 0},
                up[] = {0, 3, 0};
    const float into[] = {0, 0, -12}, back[] = {0, 0, 12}, ceiling[] = {-3, 1.5f, -12};
    const float end[] = {-3, -1.5f, -12};
    add_panel(left, across, into, 4);
    add_panel(ceiling, across, back, 4);
    add_panel(left, into, up, 4);
    add_panel(right, back, up, 4);
    add_panel(end, across, up, 3);

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_EXP2);
    glFogf(GL_FOG_DENSITY, 0.09f);
    const GLfloat mist[] = {0.35f, 0.4f, 0.5f, 1};
    glFogfv(GL_FOG_COLOR, mist);
}

void draw_room() {
    glActiveTexture(GL_TEXTURE0);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, stone);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, light_map);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_MODULATE);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);

    glClientActiveTexture(GL_TEXTURE0);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &room[0].s0);
    glClientActiveTexture(GL_TEXTURE1);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &room[0].s1);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), &room[0].x);
    glColor4f(1, 1, 1, 1);
    glDrawArrays(GL_QUADS, 0, static_cast<GLsizei>(room.size()));

    glDisable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
}

void draw_grille(float z) {
    glBindTexture(GL_TEXTURE_2D, grille);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(-2, -1.5f, z);
    glTexCoord2f(4, 0);
    glVertex3f(2, -1.5f, z);
    glTexCoord2f(4, 2);
    glVertex3f(2, 0.2f, z);
    glTexCoord2f(0, 2);
    glVertex3f(-2, 0.2f, z);
    glEnd();
    glDisable(GL_ALPHA_TEST);
}

void draw_glass(float z) {
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glBegin(GL_TRIANGLE_FAN);
    glColor4f(0.9f, 0.3f, 0.2f, 0.6f);
    glVertex3f(0, 0.6f, z);
    for (int i = 0; i <= 16; ++i) {
        const float angle = 2 * Pi * static_cast<float>(i) / 16;
        glColor4f(0.2f, 0.4f, 0.9f, 0.25f);
        glVertex3f(0.9f * std::cos(angle), 0.6f + 0.7f * std::sin(angle), z);
    }
    glEnd();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void draw(int frame) {
    const float step = static_cast<float>(frame);
    glClearColor(0.35f, 0.4f, 0.5f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, 4.0 / 3.0, 0.1, 40);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0.4 * std::sin(step * 0.5f), 0, 1.5 - 0.3 * step, 0, -0.1, -6, 0, 1, 0);
    draw_room();
    draw_grille(-5);
    draw_glass(-3.5f);
}

} // namespace

int main() {
    return run("light_maps", 320, 240, 6, setup, draw);
}
