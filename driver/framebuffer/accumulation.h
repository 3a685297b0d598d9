// The accumulation buffer (GL 1.5, 4.2.4): 16 bits signed a channel, 32767 stands for 1. It lies in
// the host's memory; colours are read from and written to device memory.

#pragma once

#include "driver/framebuffer/drawable.h"
#include "model/device/device.h"
#include "model/device/registers/primitive.h"

#include <array>

namespace ffgpu::gl {

class Accumulation {
public:
    // Operations act on the pixels of `area`, which lies within the drawable.
    Accumulation(Device& device, Drawable& drawable, const Scissor& area)
        : device_(device)
        , drawable_(drawable)
        , area_(area) {}

    void clear(const std::array<float, 4>& value); // in [-1, 1]
    void add(float value);
    void multiply(float factor);

    // From the pixels of `source` at the same place, as far as it reaches; times `factor`.
    void load(const Surface& source, float factor);
    void accumulate(const Surface& source, float factor);

    // To `destination`; write_mask as Blend::write_mask.
    void give_back(const Surface& destination, float factor, unsigned write_mask);

private:
    template <class Change>
    void change_row(unsigned y, unsigned pixels, Change change);
    template <class Change>
    void change(Change change);
    template <class Combine>
    void read(const Surface& source, float factor, Combine combine);

    Device& device_;
    Drawable& drawable_;
    Scissor area_;
};

} // namespace ffgpu::gl
