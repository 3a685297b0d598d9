// In front of a unit that changes a target: reads a quad's pixels, no sooner than all quads of its
// place that came before have stored theirs (quad_interlock). docs/rtl.md says why.
//
// A quad a cycle; as many between request and store as the interlock has entries. The memory
// answers in the order of the requests. A draw without the target reads nothing.

module target_read #(
  parameter int unsigned Entries = ffgpu_registers_pkg::TargetQuads
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  // By the quad's tag: surface_place_t, and the format.
  input  logic [63:0]                     place_0_i,
  input  logic [63:0]                     place_1_i,
  input  logic [4:0]                      format_0_i,
  input  logic [4:0]                      format_1_i,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  ffgpu_pkg::quad_t                in_data_i,

  output logic                            out_valid_o,
  input  logic                            out_ready_i,
  output ffgpu_pkg::target_quad_t         out_data_o,

  input  logic                            stored_i,  // the oldest quad

  output logic                            request_valid_o,
  input  logic                            request_ready_i,
  output ffgpu_pipe_pkg::target_request_t request_o,
  input  logic                            response_valid_i,
  output logic                            response_ready_o,
  input  logic [127:0]                    response_i
);

  ffgpu_pkg::quad_t                free, quad;
  ffgpu_pipe_pkg::target_request_t words;
  logic        free_valid, free_ready, waiting_ready, quad_valid, has_target, reads, is_there;
  logic        register_ready, words_valid;
  logic [4:0]  format, waiting_format;
  logic [2:0]  upper_byte, lower_byte, waiting_upper, waiting_lower;
  logic [63:0] upper_word, lower_word;
  logic [127:0] both_words, pixels;

  quad_interlock #(
    .Entries(Entries)
  ) u_interlock (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .out_valid_o(free_valid),
    .out_ready_i(free_ready),
    .out_data_o (free),
    .release_i  (stored_i)
  );

  assign format     = free.tag ? format_1_i : format_0_i;
  assign has_target = format != ffgpu_registers_pkg::FormatNone;
  target_place u_place (
    .surface_i   (free.tag ? place_1_i : place_0_i),
    .format_i    (format),
    .x_i         (free.x),
    .y_i         (free.y),
    .words_o     (words),
    .upper_byte_o(upper_byte),
    .lower_byte_o(lower_byte)
  );

  assign free_ready = waiting_ready && (register_ready || !has_target);
  pipeline_register #(
    .Width($bits(words))
  ) u_request (
    .clk_i,
    .rst_ni,
    .in_valid_i (free_valid && waiting_ready && has_target),
    .in_ready_o (register_ready),
    .in_data_i  (words),
    .out_valid_o(request_valid_o),
    .out_ready_i(request_ready_i),
    .out_data_o (request_o)
  );
  fifo #(
    .Width(1 + 5 + 6 + $bits(free)),
    .Depth(Entries)
  ) u_waiting (
    .clk_i,
    .rst_ni,
    .in_valid_i (free_valid && (register_ready || !has_target)),
    .in_ready_o (waiting_ready),
    .in_data_i  ({has_target, format, upper_byte, lower_byte, free}),
    .out_valid_o(quad_valid),
    .out_ready_i(out_ready_i && is_there),
    .out_data_o ({reads, waiting_format, waiting_upper, waiting_lower, quad})
  );

  pipeline_register #(
    .Width(128)
  ) u_response (
    .clk_i,
    .rst_ni,
    .in_valid_i (response_valid_i),
    .in_ready_o (response_ready_o),
    .in_data_i  (response_i),
    .out_valid_o(words_valid),
    .out_ready_i(quad_valid && reads && out_ready_i),
    .out_data_o (both_words)
  );

  // Two pixels a row, as wide as the format has them.
  assign is_there    = !reads || words_valid;
  assign out_valid_o = quad_valid && is_there;
  assign upper_word  = both_words[127:64] >> {waiting_upper, 3'd0};
  assign lower_word  = both_words[63:0] >> {waiting_lower, 3'd0};
  always_comb begin
    case (ffgpu_pipe_pkg::pixel_bytes_log2(waiting_format))
      2'd2: pixels = {upper_word, lower_word};
      2'd1: pixels = {32'(upper_word[31:16]), 32'(upper_word[15:0]),
                      32'(lower_word[31:16]), 32'(lower_word[15:0])};
      default: pixels = {32'(upper_word[15:8]), 32'(upper_word[7:0]),
                         32'(lower_word[15:8]), 32'(lower_word[7:0])};
    endcase
  end
  assign out_data_o = {quad, reads ? pixels : 128'd0};

endmodule
