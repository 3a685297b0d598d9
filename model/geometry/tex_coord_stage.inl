// Texture coordinates: generation in its five modes, then the texture matrix (GL 1.5, 2.10.2,
// 2.10.4).

namespace ffgpu::FFGPU_LANES {

// u: from the eye to the vertex, normalised; r: u mirrored at the vertex's plane.
inline Floats3 reflection(const Floats3& view, const Floats3& normal) {
    const Floats3 u = normalize(view);
    const Floats twice = splat(2.0f) * dot(normal, u);
    return u - normal * twice;
}

inline Floats sphere_map(const Floats3& r, unsigned coordinate) {
    const Floats z = r[2] + splat(1.0f);
    const Floats m = splat(2.0f) * square_root((r[0] * r[0] + r[1] * r[1]) + z * z);
    return r[coordinate] / m + splat(0.5f);
}

inline Floats generate_coordinate(const TexCoordSetup& registers,
                                  const VertexBatch& batch,
                                  unsigned coordinate,
                                  unsigned lane) {
    const auto& position = batch.in[static_cast<unsigned>(Attribute::Position)];
    const unsigned axis = coordinate < 3 ? coordinate : 0; // Those modes have no q.
    switch (registers.mode[coordinate]) {
    case TexGenMode::ObjectLinear:
        return dot(registers.plane[coordinate], load4(position, lane));
    case TexGenMode::EyeLinear:
        return dot(registers.plane[coordinate], load4(batch.eye, lane));
    case TexGenMode::SphereMap:
        return sphere_map(reflection(load3(batch.view, lane), load3(batch.normal, lane)), axis);
    case TexGenMode::NormalMap:
        return load(batch.normal[axis].at(lane));
    default:
        return reflection(load3(batch.view, lane), load3(batch.normal, lane))[axis];
    }
}

inline void tex_coord_unit(const TexCoordUnit& unit, VertexBatch& batch) {
    const TexCoordSetup& registers = *unit.registers;
    const auto& in = batch.in[static_cast<unsigned>(tex_coord(unit.unit))];
    auto& out = batch.tex[unit.unit];
    for (unsigned lane = 0; lane < batch.count; lane += LaneCount) {
        Floats4 coordinates = load4(in, lane);
        for (unsigned i = 0; i < 4 && unit.generate; ++i)
            if (registers.mode[i] != TexGenMode::Off)
                coordinates[i] = generate_coordinate(registers, batch, i, lane);
        for (unsigned row = 0; row < unit.components; ++row)
            store(registers.matrix_enable ? transform_row(registers.matrix, row, coordinates)
                                          : coordinates[row],
                  out[row].at(lane));
    }
}

inline void tex_coord_stage(const VertexSetup& setup, VertexBatch& batch) {
    for (unsigned i = 0; i < setup.unit_count; ++i)
        tex_coord_unit(setup.units[i], batch);
}

} // namespace ffgpu::FFGPU_LANES
