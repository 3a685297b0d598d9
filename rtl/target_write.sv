// Behind a unit that changes a target: hands the bytes that change to the memory, and lets the quad
// go on.
//
// Latency 1 to the memory, a quad a cycle. A quad that changes no byte stores nothing. It has been
// stored when the memory, which answers later reads by it, has taken it.

module target_write (
  input  logic                          clk_i,
  input  logic                          rst_ni,

  // By the quad's tag: surface_place_t, and the format.
  input  logic [63:0]                   place_0_i,
  input  logic [63:0]                   place_1_i,
  input  logic [4:0]                    format_0_i,
  input  logic [4:0]                    format_1_i,

  input  logic                          in_valid_i,
  output logic                          in_ready_o,
  input  ffgpu_pkg::written_quad_t      in_data_i,

  output logic                          out_valid_o,
  input  logic                          out_ready_i,
  output ffgpu_pkg::quad_t              out_data_o,

  // A quad's store has been taken, or there is none. By tags, whose stores wait.
  output logic                          stored_o,
  output logic [1:0]                    waits_o,

  output logic                          store_valid_o,
  input  logic                          store_ready_i,
  output ffgpu_pipe_pkg::target_store_t store_o
);

  ffgpu_pkg::quad_t                quad;
  ffgpu_pipe_pkg::target_request_t words;
  ffgpu_pipe_pkg::target_store_t   store;
  logic [4:0]  format;
  logic [2:0]  upper_byte, lower_byte;
  logic [63:0] upper, lower;
  logic [7:0]  upper_enables, lower_enables;
  logic        stores, register_ready, waits, waiting_tag, waiting_stores;

  assign quad   = in_data_i.quad;
  assign format = quad.tag ? format_1_i : format_0_i;
  assign stores = in_data_i.enables != 16'd0;

  target_place u_place (
    .surface_i   (quad.tag ? place_1_i : place_0_i),
    .format_i    (format),
    .x_i         (quad.x),
    .y_i         (quad.y),
    .words_o     (words),
    .upper_byte_o(upper_byte),
    .lower_byte_o(lower_byte)
  );

  // Pixels lie as wide as the format has them.
  always_comb begin
    case (ffgpu_pipe_pkg::pixel_bytes_log2(format))
      2'd2: begin
        {upper, lower}                 = in_data_i.pixels;
        {upper_enables, lower_enables} = in_data_i.enables;
      end
      2'd1: begin
        upper         = 64'({in_data_i.pixels[111:96], in_data_i.pixels[79:64]});
        lower         = 64'({in_data_i.pixels[47:32], in_data_i.pixels[15:0]});
        upper_enables = 8'({in_data_i.enables[13:12], in_data_i.enables[9:8]});
        lower_enables = 8'({in_data_i.enables[5:4], in_data_i.enables[1:0]});
      end
      default: begin
        upper         = 64'({in_data_i.pixels[103:96], in_data_i.pixels[71:64]});
        lower         = 64'({in_data_i.pixels[39:32], in_data_i.pixels[7:0]});
        upper_enables = 8'({in_data_i.enables[12], in_data_i.enables[8]});
        lower_enables = 8'({in_data_i.enables[4], in_data_i.enables[0]});
      end
    endcase
  end
  assign store = {words, upper_enables << upper_byte, lower_enables << lower_byte,
                  upper << {upper_byte, 3'd0}, lower << {lower_byte, 3'd0}};

  // Quad and store part here, at once. A register that is ready stays so until it is used: what is
  // offered to either side is held though the other one waits, whatever the memory does.
  assign in_ready_o  = out_ready_i && register_ready;
  assign out_valid_o = in_valid_i && register_ready;
  assign out_data_o  = quad;
  pipeline_register #(
    .Width(2 + $bits(store))
  ) u_store (
    .clk_i,
    .rst_ni,
    .in_valid_i (in_valid_i && out_ready_i),
    .in_ready_o (register_ready),
    .in_data_i  ({quad.tag, stores, store}),
    .out_valid_o(waits),
    .out_ready_i(store_ready_i || !waiting_stores),
    .out_data_o ({waiting_tag, waiting_stores, store_o})
  );
  assign store_valid_o = waits && waiting_stores;
  assign stored_o      = waits && (store_ready_i || !waiting_stores);
  assign waits_o       = {waits && waiting_tag, waits && !waiting_tag};

endmodule
