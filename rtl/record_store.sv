// Planes and shading headers of the primitives that are between set-up and their last attribute.
//
// A primitive's planes are written first, then its record is taken, which gives it its slot; the
// slot is free again when the primitive has been walked and all quads found of it have been
// interpolated. Slots are used in turn. Reads are combinational.

module record_store (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,

  input  logic                                 plane_valid_i,
  output logic                                 plane_ready_o,
  input  ffgpu_pipe_pkg::plane_write_t         plane_i,

  // The record of the planes written since the last one.
  input  logic                                 record_taken_i,
  input  ffgpu_pipe_pkg::shading_header_t      header_i,
  output logic                                 record_ready_o,
  output logic [ffgpu_pipe_pkg::SlotWidth-1:0] record_slot_o,

  // Of the primitive that is walked.
  input  logic                                 walking_i,
  input  logic [ffgpu_pipe_pkg::SlotWidth-1:0] walked_slot_i,
  input  logic                                 found_i,
  // A quad needs its planes no more.
  input  logic                                 done_i,
  input  logic [ffgpu_pipe_pkg::SlotWidth-1:0] done_slot_i,

  // Headers of all slots, and the biased exponents of q's planes, unit 0 lowest.
  output logic [4*129-1:0]                     headers_o,
  output logic [4*64-1:0]                      q_scales_o,

  input  logic [ffgpu_pipe_pkg::SlotWidth-1:0] first_slot_i,
  input  logic [5:0]                           first_attribute_i,
  output ffgpu_pipe_pkg::plane_t               first_plane_o,
  input  logic [ffgpu_pipe_pkg::SlotWidth-1:0] second_slot_i,
  input  logic [5:0]                           second_attribute_i,
  output ffgpu_pipe_pkg::plane_t               second_plane_o
);

  localparam int unsigned SlotWidth = ffgpu_pipe_pkg::SlotWidth;
  localparam int unsigned Slots = ffgpu_pipe_pkg::Slots;
  localparam int unsigned CountWidth = 8;  // more quads than can be between the two
  localparam int unsigned HeaderWidth = 129;

  logic [143:0]                  planes_q [Slots*64];
  logic [Slots*HeaderWidth-1:0]  headers_q;
  logic [Slots*64-1:0]           q_scales_q;
  logic [SlotWidth:0]            oldest_q, fill_q;  // With a bit more, which tells full from empty.
  logic [Slots*CountWidth-1:0]   counts_q, counts_d;
  logic                          has_room, frees, is_walked, writes;
  logic [SlotWidth-1:0]          oldest, fill;
  logic [2:0]                    unit;
  ffgpu_pipe_pkg::plane_t        plane;

  assign oldest         = oldest_q[SlotWidth-1:0];
  assign fill           = fill_q[SlotWidth-1:0];
  assign has_room       = oldest_q != {~fill_q[SlotWidth], fill};
  assign plane_ready_o  = has_room;
  assign record_ready_o = has_room;
  assign record_slot_o  = fill;
  assign writes         = plane_valid_i && plane_ready_o;
  assign headers_o      = headers_q;
  assign q_scales_o     = q_scales_q;
  assign is_walked      = walking_i && walked_slot_i == oldest;
  assign frees          = oldest_q != fill_q && !is_walked &&
    counts_q[CountWidth*oldest +: CountWidth] == '0;

  always_comb begin
    counts_d = counts_q;
    if (found_i) begin
      counts_d[CountWidth*walked_slot_i +: CountWidth] =
        counts_d[CountWidth*walked_slot_i +: CountWidth] + 8'd1;
    end
    if (done_i) begin
      counts_d[CountWidth*done_slot_i +: CountWidth] =
        counts_d[CountWidth*done_slot_i +: CountWidth] - 8'd1;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      oldest_q <= '0;
      fill_q   <= '0;
      counts_q <= '0;
    end else begin
      counts_q <= counts_d;
      oldest_q <= oldest_q + {{SlotWidth{1'b0}}, frees};
      fill_q   <= fill_q + {{SlotWidth{1'b0}}, record_taken_i};
    end
  end

  assign plane = plane_i.plane;
  assign unit  = {plane_i.attribute[5], plane_i.attribute[3:2]};
  always_ff @(posedge clk_i) begin
    if (writes) begin
      planes_q[{fill, plane_i.attribute}] <= plane_i.plane;
    end
    // Place by place: one in so wide a vector would be a shifter.
    if (writes && plane_i.attribute[1:0] == 2'd3) begin
      for (int unsigned i = 0; i < Slots * 8; i++) begin
        if ({fill, unit} == i[SlotWidth+2:0]) begin
          q_scales_q[8*i +: 8] <= plane.scale;
        end
      end
    end
    if (record_taken_i) begin
      for (int unsigned i = 0; i < Slots; i++) begin
        if (fill == i[SlotWidth-1:0]) begin
          headers_q[HeaderWidth*i +: HeaderWidth] <= header_i;
        end
      end
    end
  end

  assign first_plane_o  = planes_q[{first_slot_i, first_attribute_i}];
  assign second_plane_o = planes_q[{second_slot_i, second_attribute_i}];

endmodule
