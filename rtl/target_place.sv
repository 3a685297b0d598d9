// Where a quad stands in a target: the aligned words of 8 bytes that its two rows lie in, and its
// first pixel's byte in them, which is even.
//
// Combinational. Address and stride are multiples of the bytes of two pixels, so that no row of a
// quad lies in two words.

module target_place (
  input  ffgpu_pipe_pkg::surface_place_t  surface_i,
  input  logic [4:0]                      format_i,
  input  logic [12:0]                     x_i,  // even, as y
  input  logic [12:0]                     y_i,
  output ffgpu_pipe_pkg::target_request_t words_o,
  output logic [2:0]                      upper_byte_o,
  output logic [2:0]                      lower_byte_o
);

  logic [31:0] row, lower, upper;

  assign row          = surface_i.stride * {19'd0, y_i};
  assign lower        = surface_i.address + row +
    ({19'd0, x_i} << ffgpu_pipe_pkg::pixel_bytes_log2(format_i));
  assign upper        = lower + surface_i.stride;
  assign words_o      = {upper[31:3], 3'd0, lower[31:3], 3'd0};
  assign upper_byte_o = {upper[2:1], 1'b0};
  assign lower_byte_o = {lower[2:1], 1'b0};

endmodule
