#include "driver/get/state_variable.h"

#include "driver/context/context.h"
#include "driver/get/client_arrays.h"
#include "driver/state/capabilities.h"

#include <algorithm>
#include <vector>

namespace ffgpu::gl {
namespace {

constexpr auto ByName = [](const StateVariable& a, const StateVariable& b) {
    return a.name < b.name;
};

std::vector<StateVariable> merge() {
    std::vector<StateVariable> all;
    for (const auto part : {current_variables(),
                            array_variables(),
                            transform_variables(),
                            lighting_variables(),
                            rasterization_variables(),
                            texture_variables(),
                            fragment_variables(),
                            framebuffer_variables(),
                            pixel_variables(),
                            miscellaneous_variables(),
                            limit_variables()})
        all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end(), ByName);
    return all;
}

} // namespace

std::span<const StateVariable> state_variables() {
    static const std::vector<StateVariable> all = merge();
    return all;
}

StateValue find_state(Context& context, GLenum name) {
    const std::span all = state_variables();
    const auto found =
        std::lower_bound(all.begin(), all.end(), StateVariable{name, nullptr}, ByName);
    if (found != all.end() && found->name == name) return found->get(context);
    if (const Capability* const capability = find_capability(name))
        return values::boolean(capability_flag(*capability, context.state, name));
    if (const VertexArray* const array = find_client_array(context.client.arrays, name))
        return values::boolean(array->enabled);
    return {};
}

} // namespace ffgpu::gl
