// Colours of vertices: lighting (GL 1.5, 2.14.1), or the vertices' own, clamped to [0, 1].
//
// The lights' colours are summed first, weighted; the material's colours multiply the sums:
//     colour = emission + ambient (scene + sum w_a L_a) + diffuse sum w_d L_d + specular sum w_s
//     L_s
// so that a material that follows the vertices' colours (2.14.3) costs nothing more.

namespace ffgpu::FFGPU_LANES {

struct LightSums {
    Floats3 ambient, diffuse, specular;
};

// Where a light stands as seen from the vertices, and how strong it is there.
struct LightRay {
    Floats3 direction; // from the vertex to the light, normalised
    Floats weight;     // attenuation times the spot light's factor
};

inline Floats spot_factor(const LightSource& light, const Floats3& direction) {
    const Floats cosine = negate(dot(direction, splat3(light.spot_direction)));
    const Mask inside = cosine >= splat(light.spot_cutoff_cosine);
    if (light.spot_exponent == 0) return zero_unless(inside, splat(1.0f));
    return zero_unless(inside, power_lanes(cosine, splat(light.spot_exponent)));
}

inline LightRay light_ray(const LightSource& light, const Floats3& view) {
    LightRay ray{splat3(light.position), splat(1.0f)};
    if (!light.directional) {
        const Floats3 to_light = splat3(light.position) - view;
        ray.direction = normalize(to_light);
        if (light.attenuates) {
            const Floats square = dot(to_light, to_light);
            const Floats linear = splat(light.attenuation[1]) * square_root(square);
            const Floats quadratic = splat(light.attenuation[2]) * square;
            ray.weight = splat(1.0f) / ((splat(light.attenuation[0]) + linear) + quadratic);
        }
    }
    if (light.spot) ray.weight = ray.weight * spot_factor(light, ray.direction);
    return ray;
}

inline void add_weighted(Floats3& sum, Floats weight, const Vec3& color) {
    for (unsigned c = 0; c < 3; ++c)
        sum[c] = sum[c] + weight * splat(color[c]);
}

// n_dot_light and n_dot_half: of the side's normal. Where the light is behind the surface the
// diffuse and specular weights are exactly 0, so that leaving the terms out changes nothing.
inline void add_light(const LightSource& light,
                      const MaterialSide& side,
                      const LightRay& ray,
                      const std::array<Floats, 2>& n_dot_light_half,
                      LightSums& sums) {
    const auto [n_dot_light, n_dot_half] = n_dot_light_half;
    const Mask lit = n_dot_light > splat(0.0f);
    add_weighted(sums.ambient, ray.weight, light.ambient);
    if (!any(lit)) return;
    add_weighted(sums.diffuse, zero_unless(lit, ray.weight * n_dot_light), light.diffuse);
    if (side.has_specular) {
        const Floats highlight = power_lanes(n_dot_half, splat(side.shininess));
        add_weighted(sums.specular, zero_unless(lit, ray.weight * highlight), light.specular);
    }
}

inline void store_side(const LightingSetup& setup,
                       unsigned side,
                       const LightSums& sums,
                       VertexBatch& batch,
                       unsigned lane) {
    const MaterialSide& material = setup.sides[side];
    const auto& vertex_color = batch.in[static_cast<unsigned>(Attribute::Color)];
    const auto property = [&](ColorMaterialBit bit, const Vec3& value, unsigned c) {
        return material.color_material & bit ? load(vertex_color[c].at(lane)) : splat(value[c]);
    };
    for (unsigned c = 0; c < 3; ++c) {
        const Floats ambient = property(ColorMaterialAmbient, material.ambient, c);
        const Floats diffuse = property(ColorMaterialDiffuse, material.diffuse, c);
        const Floats specular = property(ColorMaterialSpecular, material.specular, c);
        const Floats highlight = specular * sums.specular[c];
        Floats color = property(ColorMaterialEmission, material.emission, c);
        color = color + ambient * (splat(setup.scene_ambient[c]) + sums.ambient[c]);
        color = color + diffuse * sums.diffuse[c];
        if (!setup.separate_specular) color = color + highlight;
        store(clamp_color(color), batch.color[side][c].at(lane));
        store(setup.separate_specular ? clamp_color(highlight) : splat(0.0f),
              batch.secondary[side][c].at(lane));
    }
    const Floats alpha = material.color_material & ColorMaterialDiffuse
                             ? load(vertex_color[3].at(lane))
                             : splat(material.alpha);
    store(clamp_color(alpha), batch.color[side][3].at(lane));
}

inline void light_lanes(const LightingSetup& setup, VertexBatch& batch, unsigned lane) {
    const Floats zero = splat(0.0f);
    const LightSums dark{{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
    LightSums front = dark, back = dark;

    const Floats3 normal = load3(batch.normal, lane);
    const Floats3 view = load3(batch.view, lane);
    Floats3 to_viewer{zero, zero, splat(1.0f)};
    if (setup.local_viewer) to_viewer = normalize(Floats3{zero, zero, zero} - view);

    for (unsigned i = 0; i < setup.count; ++i) {
        const LightSource& light = setup.lights[i];
        const LightRay ray = light_ray(light, view);
        const Floats3 half_way = light.directional && !setup.local_viewer
                                     ? splat3(light.half_way)
                                     : normalize(ray.direction + to_viewer);
        const Floats n_dot_light = dot(normal, ray.direction);
        const Floats n_dot_half = dot(normal, half_way);
        add_light(light, setup.sides[0], ray, {n_dot_light, n_dot_half}, front);
        if (setup.two_sided) {
            add_light(light, setup.sides[1], ray, {negate(n_dot_light), negate(n_dot_half)}, back);
        }
    }
    store_side(setup, 0, front, batch, lane);
    if (setup.two_sided) store_side(setup, 1, back, batch, lane);
}

inline void color_stage(const VertexSetup& setup, VertexBatch& batch) {
    const auto& color = batch.in[static_cast<unsigned>(Attribute::Color)];
    const auto& secondary = batch.in[static_cast<unsigned>(Attribute::SecondaryColor)];
    const bool has_color = setup.layout.color >= 0, has_secondary = setup.layout.secondary >= 0;
    for (unsigned lane = 0; lane < batch.count; lane += LaneCount) {
        if (setup.lighting.enable) {
            light_lanes(setup.lighting, batch, lane);
            continue;
        }
        for (unsigned c = 0; c < 4 && has_color; ++c)
            store(clamp_color(load(color[c].at(lane))), batch.color[0][c].at(lane));
        for (unsigned c = 0; c < 3 && has_secondary; ++c)
            store(clamp_color(load(secondary[c].at(lane))), batch.secondary[0][c].at(lane));
    }
}

} // namespace ffgpu::FFGPU_LANES
