// What depends on the distance from the eye: the fog coordinate (GL 1.5, 3.10) and the size of
// points (3.3).

namespace ffgpu::FFGPU_LANES {

inline Floats fog_coordinate(FogCoordinateSource source, const VertexBatch& batch, unsigned lane) {
    switch (source) {
    case FogCoordinateSource::EyeZ:
        return absolute(load(batch.view[2].at(lane)));
    case FogCoordinateSource::EyeZSigned:
        return load(batch.view[2].at(lane));
    case FogCoordinateSource::EyeRadial: {
        const Floats3 view = load3(batch.view, lane);
        return square_root(dot(view, view));
    }
    default:
        return load(batch.in[static_cast<unsigned>(Attribute::FogCoordinate)][0].at(lane));
    }
}

inline Floats point_size(const VertexSetup& setup, const VertexBatch& batch, unsigned lane) {
    const PrimitiveSetup& registers = setup.registers->primitive;
    Floats size = splat(registers.point_size);
    if (setup.attenuates_points) {
        // The distance is |z_eye|: GL asks for it to the eye itself, but its implementations and
        // the programs made for them know this one, as for fog.
        const Floats distance = absolute(load(batch.view[2].at(lane)));
        const Floats linear = splat(registers.point_attenuation[1]) * distance;
        const Floats quadratic = splat(registers.point_attenuation[2]) * (distance * distance);
        const Floats divisor = (splat(registers.point_attenuation[0]) + linear) + quadratic;
        size = size * square_root(splat(1.0f) / divisor);
    }
    return minimum(maximum(size, splat(registers.point_size_min)), splat(registers.point_size_max));
}

inline void distance_stage(const VertexSetup& setup, VertexBatch& batch) {
    const FogCoordinateSource source = setup.registers->fog.source;
    for (unsigned lane = 0; lane < batch.count; lane += LaneCount) {
        if (setup.layout.fog >= 0) store(fog_coordinate(source, batch, lane), batch.fog.at(lane));
        if (setup.needs.point_size)
            store(point_size(setup, batch, lane), batch.point_size.at(lane));
    }
}

} // namespace ffgpu::FFGPU_LANES
