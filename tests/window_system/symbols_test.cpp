// What the library exports.

#include <string>

#include <catch2/catch.hpp>
#include <dlfcn.h>

// As a wrapper has it that is loaded before the library: apitrace's, an overlay's.
extern "C" __attribute__((visibility("default"))) void glFogCoordd(double);
void glFogCoordd(double) {}

namespace {

void* open(const char* name) {
    return ::dlopen((std::string(FFGPU_LIBRARY_FOLDER "/") + name).c_str(), RTLD_NOW | RTLD_LOCAL);
}

constexpr const char* Commands[] = {
#define GL_COMMAND(result, name, parameters, arguments, command_class) "gl" #name,
#define GL_ALIAS(result, name, parameters, arguments, target) "gl" #name,
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
};

// Of GLX 1.4 and of what programs of its time are linked with.
constexpr const char* GlxFunctions[] = {"glXChooseFBConfig",
                                        "glXChooseVisual",
                                        "glXCopyContext",
                                        "glXCreateContext",
                                        "glXCreateContextAttribsARB",
                                        "glXCreateGLXPixmap",
                                        "glXCreateNewContext",
                                        "glXCreatePbuffer",
                                        "glXCreatePixmap",
                                        "glXCreateWindow",
                                        "glXDestroyContext",
                                        "glXDestroyGLXPixmap",
                                        "glXDestroyPbuffer",
                                        "glXDestroyPixmap",
                                        "glXDestroyWindow",
                                        "glXGetClientString",
                                        "glXGetConfig",
                                        "glXGetCurrentContext",
                                        "glXGetCurrentDisplay",
                                        "glXGetCurrentDrawable",
                                        "glXGetCurrentReadDrawable",
                                        "glXGetFBConfigAttrib",
                                        "glXGetFBConfigs",
                                        "glXGetProcAddress",
                                        "glXGetProcAddressARB",
                                        "glXGetSelectedEvent",
                                        "glXGetVisualFromFBConfig",
                                        "glXIsDirect",
                                        "glXMakeContextCurrent",
                                        "glXMakeCurrent",
                                        "glXQueryContext",
                                        "glXQueryDrawable",
                                        "glXQueryExtension",
                                        "glXQueryExtensionsString",
                                        "glXQueryServerString",
                                        "glXQueryVersion",
                                        "glXSelectEvent",
                                        "glXSwapBuffers",
                                        "glXSwapIntervalSGI",
                                        "glXUseXFont",
                                        "glXWaitGL",
                                        "glXWaitX"};

constexpr const char* EglFunctions[] = {"eglBindAPI",
                                        "eglBindTexImage",
                                        "eglChooseConfig",
                                        "eglClientWaitSync",
                                        "eglCopyBuffers",
                                        "eglCreateContext",
                                        "eglCreateImage",
                                        "eglCreatePbufferFromClientBuffer",
                                        "eglCreatePbufferSurface",
                                        "eglCreatePixmapSurface",
                                        "eglCreatePlatformPixmapSurface",
                                        "eglCreatePlatformWindowSurface",
                                        "eglCreateSync",
                                        "eglCreateWindowSurface",
                                        "eglDestroyContext",
                                        "eglDestroyImage",
                                        "eglDestroySurface",
                                        "eglDestroySync",
                                        "eglGetConfigAttrib",
                                        "eglGetConfigs",
                                        "eglGetCurrentContext",
                                        "eglGetCurrentDisplay",
                                        "eglGetCurrentSurface",
                                        "eglGetDisplay",
                                        "eglGetError",
                                        "eglGetPlatformDisplay",
                                        "eglGetProcAddress",
                                        "eglGetSyncAttrib",
                                        "eglInitialize",
                                        "eglMakeCurrent",
                                        "eglQueryAPI",
                                        "eglQueryContext",
                                        "eglQueryString",
                                        "eglQuerySurface",
                                        "eglReleaseTexImage",
                                        "eglReleaseThread",
                                        "eglSurfaceAttrib",
                                        "eglSwapBuffers",
                                        "eglSwapInterval",
                                        "eglTerminate",
                                        "eglWaitClient",
                                        "eglWaitGL",
                                        "eglWaitNative",
                                        "eglWaitSync"};

TEST_CASE("libGL.so.1 exports each GL command, and glXGetProcAddress finds the same") {
    void* const library = open("libGL.so.1");
    REQUIRE(library);
    using GetProcAddress = void* (*)(const unsigned char*);
    const auto get = reinterpret_cast<GetProcAddress>(::dlsym(library, "glXGetProcAddress"));
    REQUIRE(get);
    for (const char* name : Commands) {
        INFO(name);
        void* const exported = ::dlsym(library, name);
        CHECK(exported != nullptr);
        CHECK(get(reinterpret_cast<const unsigned char*>(name)) == exported);
    }
}

TEST_CASE("glXGetProcAddress finds the library's own functions behind a wrapper's") {
    void* const library = open("libGL.so.1");
    REQUIRE(::dlsym(RTLD_DEFAULT, "glFogCoordd") == reinterpret_cast<void*>(&glFogCoordd));
    using GetProcAddress = void* (*)(const unsigned char*);
    const auto get = reinterpret_cast<GetProcAddress>(::dlsym(library, "glXGetProcAddress"));
    void* const found = get(reinterpret_cast<const unsigned char*>("glFogCoordd"));
    CHECK(found != nullptr);
    CHECK(found != reinterpret_cast<void*>(&glFogCoordd)); // It would call itself.
}

TEST_CASE("libGL.so.1 exports GLX 1.4, libEGL.so.1 EGL 1.5") {
    void* const gl = open("libGL.so.1");
    for (const char* name : GlxFunctions) {
        INFO(name);
        CHECK(::dlsym(gl, name) != nullptr);
    }
    void* const egl = open("libEGL.so.1");
    REQUIRE(egl);
    for (const char* name : EglFunctions) {
        INFO(name);
        CHECK(::dlsym(egl, name) != nullptr);
    }
}

TEST_CASE("commands of later versions can be linked with but are not found by name") {
    void* const library = open("libGL.so.1");
    CHECK(::dlsym(library, "glCreateShader") != nullptr);
    using GetProcAddress = void* (*)(const unsigned char*);
    const auto get = reinterpret_cast<GetProcAddress>(::dlsym(library, "glXGetProcAddress"));
    CHECK(get(reinterpret_cast<const unsigned char*>("glCreateShader")) == nullptr);
    CHECK(get(reinterpret_cast<const unsigned char*>("malloc")) == nullptr);
}

} // namespace
