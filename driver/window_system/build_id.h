// What a drop-in library and the recorder that it loads were built from, in a word: a hash of the
// model's sources and of the interface between the two. Their calls are virtual ones; of two builds
// they would end anywhere.

#pragma once

namespace ffgpu::gl {

const char* build_id();

} // namespace ffgpu::gl
