// Which draws share the part of a context that makes pixels.

#include "model/gpu/draw_context.h"
#include "model/gpu/stages.h"

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

class Draws {
public:
    std::shared_ptr<const PixelContext> pixels(const Registers& registers) {
        return contexts_.of(compile_draw_state(std::make_shared<const Registers>(registers), 0));
    }

private:
    std::vector<std::byte> memory_ = std::vector<std::byte>(1 << 16);
    PixelContexts contexts_{memory_, *FastStages.fragment};
};

} // namespace

TEST_CASE("A draw that goes back to earlier values gets the pixel context of then") {
    Draws draws;
    Registers registers;
    const auto first = draws.pixels(registers);
    registers.blend.enable = true;
    const auto second = draws.pixels(registers);
    CHECK(first != second);
    registers.blend.enable = false;
    registers.transform.model_view[0] = 2; // which makes no pixels
    CHECK(draws.pixels(registers) == first);
    registers.blend.enable = true;
    CHECK(draws.pixels(registers) == second);
}

TEST_CASE("From the first to the last register behind geometry a change is another context") {
    Draws draws;
    Registers registers;
    const auto plain = draws.pixels(registers);
    SECTION("first") {
        registers.primitive.flat_shading = true;
    }
    SECTION("an image") {
        registers.images[TextureUnits - 1].address = 64;
    }
    SECTION("a sampler") {
        registers.samplers[3].max_level = 5;
    }
    SECTION("last") {
        registers.targets.depth.address = 4096;
    }
    const auto other = draws.pixels(registers);
    CHECK(other != plain);
    CHECK(*other->pipe.registers == registers);
}

TEST_CASE("Other interpolants are another context, though only geometry's registers differ") {
    Draws draws;
    Registers registers;
    registers.targets.color[0] = {.format = Format::Rgba8, .width = 16, .height = 16, .stride = 64};
    registers.images[0].shape = {.kind = TextureKind::TwoD, .format = Format::Rgba8, .width = 4};
    registers.combiners[0].enable = true;
    registers.combiners[0].rgb.arguments[0].source = CombineSource::Texture0;
    const auto affine = draws.pixels(registers);
    registers.tex_coords[0].matrix_enable = true;
    registers.tex_coords[0].matrix[3] = 1; // q varies
    const auto projective = draws.pixels(registers);
    CHECK(affine->layout.tex_components[0] == 2);
    CHECK(projective->layout.tex_components[0] == 4);
}

TEST_CASE("What was made long ago is compiled anew, with the same values") {
    Draws draws;
    Registers registers;
    const auto first = draws.pixels(registers);
    for (std::uint16_t width = 1; width < 100; ++width) {
        registers.scissor.width = width;
        CHECK(draws.pixels(registers)->pipe.registers->scissor.width == width);
    }
    registers.scissor = {};
    const auto again = draws.pixels(registers);
    CHECK(again != first);
    CHECK(*again->pipe.registers == *first->pipe.registers);
}
