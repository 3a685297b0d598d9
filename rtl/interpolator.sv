// From quads to colours, fog coordinates and texture coordinates: record_store's planes, visited
// twice (divisor_pass, attribute_pass), and quad_collect.

module interpolator (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic [47:0]                     carried_0_i,
  input  logic [47:0]                     carried_1_i,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  ffgpu_pipe_pkg::slotted_quad_t   in_data_i,

  // The record store: two visitors, and the end of a quad's second visit.
  input  logic [4*129-1:0]                headers_i,
  input  logic [4*64-1:0]                 q_scales_i,
  output logic [1:0]                      first_slot_o,
  output logic [5:0]                      first_attribute_o,
  input  ffgpu_pipe_pkg::plane_t          first_plane_i,
  output logic [1:0]                      second_slot_o,
  output logic [5:0]                      second_attribute_o,
  input  ffgpu_pipe_pkg::plane_t          second_plane_i,
  output logic                            done_o,
  output logic [1:0]                      done_slot_o,

  output logic                            request_valid_o,
  input  logic                            request_ready_i,
  output ffgpu_pipe_pkg::sample_request_t request_o,

  output logic                            out_valid_o,
  input  logic                            out_ready_i,
  output ffgpu_pipe_pkg::pending_quad_t   out_data_o
);

  localparam int unsigned CollectDepth = 8;

  ffgpu_pipe_pkg::slotted_quad_t   quad;
  ffgpu_pipe_pkg::collected_quad_t issued, collected;
  ffgpu_pkg::lane_values_t         values;
  logic [127:0]                    divisor;
  logic quad_valid, quad_ready, divisor_valid, divisor_ready, issued_valid, issued_ready;
  logic collected_valid, collected_ready, values_valid, values_ready;

  divisor_pass u_divisors (
    .clk_i,
    .rst_ni,
    .carried_0_i,
    .carried_1_i,
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .headers_i,
    .slot_o         (first_slot_o),
    .attribute_o    (first_attribute_o),
    .plane_i        (first_plane_i),
    .out_valid_o    (quad_valid),
    .out_ready_i    (quad_ready),
    .out_data_o     (quad),
    .divisor_valid_o(divisor_valid),
    .divisor_ready_i(divisor_ready),
    .divisor_o      (divisor)
  );

  assign done_o      = quad_valid && quad_ready;
  assign done_slot_o = quad.slot;

  attribute_pass u_attributes (
    .clk_i,
    .rst_ni,
    .carried_0_i,
    .carried_1_i,
    .in_valid_i     (quad_valid),
    .in_ready_o     (quad_ready),
    .in_data_i      (quad),
    .divisor_valid_i(divisor_valid),
    .divisor_ready_o(divisor_ready),
    .divisor_i      (divisor),
    .headers_i,
    .q_scales_i,
    .slot_o         (second_slot_o),
    .attribute_o    (second_attribute_o),
    .plane_i        (second_plane_i),
    .quad_valid_o   (issued_valid),
    .quad_ready_i   (issued_ready),
    .quad_o         (issued),
    .out_valid_o    (values_valid),
    .out_ready_i    (values_ready),
    .out_data_o     (values)
  );
  fifo #(
    .Width($bits(issued)),
    .Depth(CollectDepth)
  ) u_issued (
    .clk_i,
    .rst_ni,
    .in_valid_i (issued_valid),
    .in_ready_o (issued_ready),
    .in_data_i  (issued),
    .out_valid_o(collected_valid),
    .out_ready_i(collected_ready),
    .out_data_o (collected)
  );
  quad_collect u_collect (
    .clk_i,
    .in_valid_i   (collected_valid),
    .in_ready_o   (collected_ready),
    .in_data_i    (collected),
    .value_valid_i(values_valid),
    .value_ready_o(values_ready),
    .value_i      (values),
    .request_valid_o,
    .request_ready_i,
    .request_o,
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
