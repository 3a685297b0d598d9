// What each part of the fragment pipe is at, bound to it: a bit where it is busy, and one where it
// has something that it cannot move. Read by the host, cycle by cycle; nothing of the pipe sees it.
//
// Bits 2 n and 2 n + 1: busy and stalled, of ffgpu::rtl::PipeUnit n. The model's accounts count the
// same (docs/rtl_cycles.md).

module pipe_activity (
  input logic       walk_steps_i,
  input logic       walk_stalls_i,
  input logic       values_step_i,
  input logic       values_stall_i,
  input logic       texels_step_i,
  input logic       texels_stall_i,
  input logic       environment_holds_i,
  input logic       environment_stalls_i,
  input logic [1:0] targets_step_i,  // depth, colour
  input logic [1:0] targets_hold_i
);

  logic [11:0] events /*verilator public_flat_rd*/;

  assign events = {targets_hold_i[1] && !targets_step_i[1], targets_step_i[1],
                   targets_hold_i[0] && !targets_step_i[0], targets_step_i[0],
                   environment_stalls_i, environment_holds_i && !environment_stalls_i,
                   texels_stall_i && !texels_step_i, texels_step_i,
                   values_stall_i && !values_step_i, values_step_i,
                   walk_stalls_i, walk_steps_i && !walk_stalls_i};

endmodule

bind fragment_pipe pipe_activity u_activity (
  .walk_steps_i(record_taken || (u_front.tile_valid && u_front.tile_ready) ||
                u_front.u_walker.active_q),
  .walk_stalls_i(u_front.u_walker.quad_valid && !u_front.u_walker.quad_ready),
  .values_step_i(u_interpolator.u_attributes.issues ||
                 (u_interpolator.u_attributes.takes_w && u_interpolator.divisor_valid) ||
                 (u_interpolator.quad_valid && u_interpolator.quad_ready)),
  .values_stall_i(u_interpolator.quad_valid &&
                  (!u_interpolator.u_attributes.takes_w || u_interpolator.divisor_valid)),
  .texels_step_i(u_texture.u_fetch.takes || (u_texture.block_valid && u_texture.block_ready) ||
                 (waiting_valid && waiting_ready)),
  .texels_stall_i(u_texture.texels_valid || u_texture.u_supply.note_valid),
  .environment_holds_i(u_shading.u_environments.has_quad_q),
  .environment_stalls_i(u_shading.u_environments.out_valid_o &&
                        !u_shading.u_environments.out_ready_i),
  .targets_step_i({u_targets.u_color_read.u_interlock.enters ||
                   (u_targets.color_valid && u_targets.color_ready),
                   u_targets.u_depth_read.u_interlock.enters ||
                   (u_targets.depth_valid && u_targets.depth_ready) ||
                   (u_targets.in_valid_i && !u_targets.lives)}),
  .targets_hold_i({u_targets.u_color_read.u_interlock.quad_valid ||
                   u_targets.u_color_read.quad_valid,
                   u_targets.u_depth_read.u_interlock.quad_valid ||
                   u_targets.u_depth_read.quad_valid})
);
