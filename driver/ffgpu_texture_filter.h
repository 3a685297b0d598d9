/* GL_FFGPU_texture_filter: filters that OpenGL does not have, one a texture object
 * (docs/texture_filters.md). For programs too: plain C, no other header needed.
 *
 * glTexParameter and glGetTexParameter take GL_TEXTURE_FILTER_FFGPU with one of the values below;
 * the initial one is GL_STANDARD_FILTER_FFGPU. They work on GL_TEXTURE_2D with an image of colours
 * and without a border; any other texture is filtered as OpenGL says. The values are registered
 * nowhere.
 */
#ifndef FFGPU_TEXTURE_FILTER_H
#define FFGPU_TEXTURE_FILTER_H

#define GL_TEXTURE_FILTER_FFGPU 0x7FF0
#define GL_STANDARD_FILTER_FFGPU 0x7FF1 /* as the minification and magnification filters say */
#define GL_BICUBIC_FILTER_FFGPU 0x7FF2  /* where GL_LINEAR would magnify */
#define GL_RIP_MAP_FILTER_FFGPU 0x7FF3
#define GL_SUMMED_AREA_FILTER_FFGPU 0x7FF4
#define GL_ELLIPTIC_FILTER_FFGPU 0x7FF5 /* where the texture is minified */
#define GL_FELINE_FILTER_FFGPU 0x7FF6   /* the same by probes of the mip map */

#endif
