// Fetched texels with the bytes that stand there: from the texel cache, or the border's colour,
// which asks no memory. In their order, ready to be decoded.

module texel_supply #(
  parameter int unsigned LineBits = ffgpu_registers_pkg::LineBits,
  parameter int unsigned FillBits = ffgpu_registers_pkg::FillBits,
  parameter int unsigned SetBits = ffgpu_registers_pkg::CacheSetBits,  // of the texel cache
  parameter int unsigned QueueDepth = ffgpu_registers_pkg::TexelQueue,
  parameter int unsigned NoteDepth = 64
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  logic                             invalidate_i,  // The cache forgets; while it is empty.

  input  ffgpu_pipe_pkg::texture_context_t bank_0_i,
  input  ffgpu_pipe_pkg::texture_context_t bank_1_i,

  input  logic                             in_valid_i,
  output logic                             in_ready_o,
  input  ffgpu_pipe_pkg::fetched_texel_t   in_data_i,

  output logic                             out_valid_o,
  input  logic                             out_ready_i,
  output ffgpu_pkg::texel_block_t          out_data_o,

  output logic                             request_valid_o,
  input  logic                             request_ready_i,
  output logic [31:0]                      request_address_o,
  output logic [FillBits-1:0]              request_fill_o,
  input  logic                             response_valid_i,
  input  logic [FillBits-1:0]              response_fill_i,
  input  logic [(8<<LineBits)-1:0]         response_line_i
);

  ffgpu_pipe_pkg::texel_note_t         note;
  ffgpu_texture_pkg::texel_data_t      data;
  ffgpu_registers_pkg::texture_image_t image;
  ffgpu_registers_pkg::sampler_t       sampler;
  logic [287:0] words;
  logic         notes_ready, cache_ready, cache_valid, note_valid, data_valid, data_ready;
  logic         is_there, is_depth, keeps_q;
  logic [31:0]  border;
  logic [127:0] block;

  // Into the cache, but for the border's, and noted.
  assign cache_valid = in_valid_i && notes_ready && !in_data_i.note.is_border;
  assign in_ready_o  = notes_ready && (cache_ready || in_data_i.note.is_border);

  fifo #(
    .Width($bits(note)),
    .Depth(NoteDepth)
  ) u_notes (
    .clk_i,
    .rst_ni,
    .in_valid_i (in_valid_i && (cache_ready || in_data_i.note.is_border)),
    .in_ready_o (notes_ready),
    .in_data_i  (in_data_i.note),
    .out_valid_o(note_valid),
    .out_ready_i(out_ready_i && is_there),
    .out_data_o (note)
  );

  // Forgetting is a reset of the cache alone.
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      keeps_q <= 1'b0;
    end else begin
      keeps_q <= !invalidate_i;
    end
  end
  texel_cache #(
    .LineBits  (LineBits),
    .FillBits  (FillBits),
    .SetBits   (SetBits),
    .QueueDepth(QueueDepth)
  ) u_cache (
    .clk_i,
    .rst_ni     (keeps_q),
    .in_valid_i (cache_valid),
    .in_ready_o (cache_ready),
    .in_data_i  ({1'b0, 10'd0, in_data_i.address}),
    .out_valid_o(data_valid),
    .out_ready_i(data_ready),
    .out_data_o (data),
    .request_valid_o,
    .request_ready_i,
    .request_address_o,
    .request_fill_o,
    .response_valid_i,
    .response_fill_i,
    .response_line_i
  );

  assign is_there    = note.is_border || data_valid;
  assign data_ready  = note_valid && !note.is_border && out_ready_i;
  assign out_valid_o = note_valid && is_there;

  assign words    = note.bank ? {bank_1_i.image, bank_1_i.sampler} :
    {bank_0_i.image, bank_0_i.sampler};
  assign image    = ffgpu_registers_pkg::decode_texture_image(words[287:192]);
  assign sampler  = ffgpu_registers_pkg::decode_sampler(words[191:0]);
  assign is_depth = image.format == ffgpu_registers_pkg::FormatDepth16 ||
    image.format == ffgpu_registers_pkg::FormatDepth24Stencil8;

  assign border   = is_depth ? {8'd0, sampler.border_depth} : sampler.border_color;

  // The texel's bytes lowest. A depth texture is not compared here: there is no reference.
  assign block = data.block >> {note.offset, 3'd0};
  always_comb begin
    out_data_o.tag             = note.bank;
    out_data_o.place           = 10'd0;
    out_data_o.is_border       = note.is_border;
    out_data_o.format          = image.format;
    out_data_o.srgb            = image.srgb && !is_depth;
    out_data_o.compare_enable  = 1'b0;
    out_data_o.relation        = sampler.compare;
    out_data_o.depth_mode      = sampler.depth_mode;
    out_data_o.depth_reference = 24'd0;
    out_data_o.x               = note.x;
    out_data_o.y               = note.y;
    out_data_o.block           = block;
    if (note.is_border) begin
      out_data_o.block = 128'(border);
    end
  end

endmodule
