// Positions to eye and clip space, normals to eye space (GL 1.5, 2.10).

namespace ffgpu::FFGPU_LANES {

inline Floats3 transform_normal(const Transform& transform, const Floats3& n) {
    const auto& m = transform.normal_matrix;
    Floats3 result;
    for (unsigned row = 0; row < 3; ++row)
        result[row] = dot(splat3({m[3 * row], m[3 * row + 1], m[3 * row + 2]}), n);
    if (transform.normal_mode == NormalMode::Rescale) return result * splat(transform.rescale);
    if (transform.normal_mode == NormalMode::Normalize) return normalize(result);
    return result;
}

inline void transform_stage(const VertexSetup& setup, VertexBatch& batch) {
    const Transform& transform = setup.registers->transform;
    const auto& positions = batch.in[static_cast<unsigned>(Attribute::Position)];
    const auto& normals = batch.in[static_cast<unsigned>(Attribute::Normal)];
    for (unsigned lane = 0; lane < batch.count; lane += LaneCount) {
        const Floats4 position = load4(positions, lane);
        for (unsigned row = 0; row < 4; ++row)
            store(transform_row(setup.model_view_projection, row, position),
                  batch.clip[row].at(lane));
        if (setup.needs_eye) {
            for (unsigned row = 0; row < 4; ++row)
                store(transform_row(transform.model_view, row, position), batch.eye[row].at(lane));
        }
        if (setup.needs_view) {
            const Floats4 eye = load4(batch.eye, lane);
            Floats3 view{eye[0], eye[1], eye[2]};
            if (!setup.eye_w_is_one) view = {eye[0] / eye[3], eye[1] / eye[3], eye[2] / eye[3]};
            store_all(view, batch.view, lane);
        }
        if (setup.needs_normal) {
            const Floats3 normal{
                load(normals[0].at(lane)), load(normals[1].at(lane)), load(normals[2].at(lane))};
            store_all(transform_normal(transform, normal), batch.normal, lane);
        }
    }
}

} // namespace ffgpu::FFGPU_LANES
