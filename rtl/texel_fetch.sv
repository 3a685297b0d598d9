// The texels of a request one after the other, each with its address in memory.
//
// Latency 1, a texel a cycle. Texel 4 z + 2 y + x; axes that the filter has not are left out. What
// the request's filter needs leaves with its last texel. Equals ffgpu::level_layout()'s places.

module texel_fetch (
  input  logic                              clk_i,
  input  logic                              rst_ni,

  // By the request's tag.
  input  ffgpu_pipe_pkg::texture_context_t  bank_0_i,
  input  ffgpu_pipe_pkg::texture_context_t  bank_1_i,

  input  logic                              in_valid_i,
  output logic                              in_ready_o,
  input  ffgpu_texture_pkg::texel_request_t in_data_i,

  output logic                              out_valid_o,
  input  logic                              out_ready_i,
  output ffgpu_pipe_pkg::fetched_texel_t    out_data_o,

  // With the last texel.
  output logic                              filter_valid_o,
  input  logic                              filter_ready_i,
  output ffgpu_pipe_pkg::filter_note_t      filter_o
);

  localparam int unsigned PlaceWidth = ffgpu_texture_pkg::TexelPlaceWidth;
  localparam int unsigned BorderBit = ffgpu_texture_pkg::TexelPlaceBorder;

  ffgpu_texture_pkg::texel_header_t    header;
  ffgpu_registers_pkg::texture_image_t image;
  ffgpu_pipe_pkg::fetched_texel_t      texel;
  logic [287:0]          words;  // of the image and the sampler
  logic [95:0]           level;
  logic [2:0]            texel_q, last_texel;
  logic                  is_last, takes, valid, ready, is_border;
  logic [PlaceWidth-1:0] x, y, z;
  logic [13:0]           column, row;
  logic [2:0]            column_bytes;  // as a power of two
  logic [31:0]           offset, row_stride, layer_stride;
  logic [31:0]           row_product, layer_product, address;

  assign header = in_data_i.header;
  assign words  = header.tag ? {bank_1_i.image, bank_1_i.sampler} :
    {bank_0_i.image, bank_0_i.sampler};
  assign level  = header.tag ? bank_1_i.levels[96*header.level +: 96] :
    bank_0_i.levels[96*header.level +: 96];
  assign image  = ffgpu_registers_pkg::decode_texture_image(words[287:192]);

  always_comb begin
    last_texel = 3'd3;
    if (image.kind == ffgpu_registers_pkg::TextureKindOneD) begin
      last_texel = 3'd1;
    end
    if (image.kind == ffgpu_registers_pkg::TextureKindThreeD) begin
      last_texel = 3'd7;
    end
    if (!header.linear) begin
      last_texel = 3'd0;
    end
  end
  assign is_last        = texel_q == last_texel;
  assign valid          = in_valid_i && (!is_last || filter_ready_i);
  assign takes          = valid && ready;
  assign in_ready_o     = ready && is_last && filter_ready_i;
  assign filter_valid_o = in_valid_i && is_last && ready;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      texel_q <= 3'd0;
    end else if (takes) begin
      texel_q <= is_last ? 3'd0 : texel_q + 3'd1;
    end
  end

  // Where it is. Compressed formats have rows of blocks.
  assign x = in_data_i.places[PlaceWidth*{2'd0, texel_q[0]} +: PlaceWidth];
  assign y = in_data_i.places[PlaceWidth*{2'd1, texel_q[1]} +: PlaceWidth];
  assign z = in_data_i.places[PlaceWidth*{2'd2, texel_q[2]} +: PlaceWidth];
  assign is_border = x[BorderBit] || y[BorderBit] || z[BorderBit];

  always_comb begin
    column = x;
    row    = {2'd0, y[13:2]};
    case (image.format)
      ffgpu_registers_pkg::FormatDxt1Rgb,
      ffgpu_registers_pkg::FormatDxt1Rgba: begin
        column       = {2'd0, x[13:2]};
        column_bytes = 3'd3;
      end
      ffgpu_registers_pkg::FormatDxt3,
      ffgpu_registers_pkg::FormatDxt5: begin
        column       = {2'd0, x[13:2]};
        column_bytes = 3'd4;
      end
      ffgpu_registers_pkg::FormatFxt1Rgb,
      ffgpu_registers_pkg::FormatFxt1Rgba: begin
        column       = {3'd0, x[13:3]};
        column_bytes = 3'd4;
      end
      default: begin
        row          = y;
        column_bytes = {1'b0, ffgpu_pipe_pkg::pixel_bytes_log2(image.format)};
      end
    endcase
  end

  assign {layer_stride, row_stride, offset} = level;
  assign row_product   = row_stride * {18'd0, row};
  assign layer_product = layer_stride * {18'd0, z};
  assign address       = image.address + offset + layer_product + row_product +
    ({18'd0, column} << column_bytes);

  always_comb begin
    texel.note.bank      = header.tag;
    texel.note.is_border = is_border;
    texel.note.x         = x[2:0];
    texel.note.y         = y[1:0];
    texel.note.offset    = address[3:0];
    texel.last           = is_last;
    texel.address        = address;
  end
  always_comb begin
    filter_o.last_texel = last_texel;
    filter_o.tag        = header.tag;
    filter_o.place      = {header.place[7:0], header.lane};
    filter_o.last_level = header.last_level;
    filter_o.last_probe = header.last_probe;
    filter_o.probes     = header.probes;
    filter_o.weights    = {header.level_weight, in_data_i.weight_z, in_data_i.weight_y,
                           in_data_i.weight_x};
  end

  pipeline_register #(
    .Width($bits(texel))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (valid),
    .in_ready_o (ready),
    .in_data_i  (texel),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
