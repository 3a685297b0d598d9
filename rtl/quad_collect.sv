// A quad's values, attribute after attribute, become its colours and fog coordinate; a texture
// unit's coordinates leave as soon as they are together, as a request for samples.
//
// A value a cycle. The requests of a quad leave before the quad or with it.

module quad_collect (
  input  logic                            clk_i,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  ffgpu_pipe_pkg::collected_quad_t in_data_i,

  // Places as attribute_pass gives them.
  input  logic                            value_valid_i,
  output logic                            value_ready_o,
  input  ffgpu_pkg::lane_values_t         value_i,

  output logic                            request_valid_o,
  input  logic                            request_ready_i,
  output ffgpu_pipe_pkg::sample_request_t request_o,

  output logic                            out_valid_o,
  input  logic                            out_ready_i,
  output ffgpu_pipe_pkg::pending_quad_t   out_data_o
);

  ffgpu_pkg::quad_t quad;
  logic [127:0]     primary_q, primary, fog_q, fog;
  logic [95:0]      secondary_q, secondary;
  logic [383:0]     coordinates_q, coordinates;
  logic [5:0]       attribute;
  logic             is_last, is_unit_last, ends;

  assign quad         = in_data_i.quad;
  assign attribute    = value_i.place[5:0];
  assign is_last      = value_i.place[6];
  assign is_unit_last = value_i.place[7];

  // The attribute's lanes into their places, if it is this quad's: what waits stays as it is. Part by
  // part: a place in so wide a vector would be a shifter.
  // What a unit's coordinates do not carry does not matter, nor what they are of a quad without
  // values, which asks for nothing.
  always_comb begin
    primary     = primary_q;
    secondary   = secondary_q;
    fog         = fog_q;
    coordinates = coordinates_q;
    if (value_valid_i) begin
      for (int unsigned lane = 0; lane < 4; lane++) begin
        for (int unsigned part = 0; part < 4; part++) begin
          if (in_data_i.has_values && attribute == {4'd1, part[1:0]}) begin
            primary[32*lane + 8*part +: 8] = value_i.values[32*lane +: 8];
          end
        end
        for (int unsigned part = 0; part < 3; part++) begin
          if (in_data_i.has_values && attribute == {4'd2, part[1:0]}) begin
            secondary[24*lane + 8*part +: 8] = value_i.values[32*lane +: 8];
          end
          if (attribute[5:4] != 2'd0 && attribute[1:0] == part[1:0]) begin
            coordinates[96*lane + 32*part +: 32] = value_i.values[32*lane +: 32];
          end
        end
        if (in_data_i.has_values && attribute == ffgpu_pipe_pkg::AttributeFog) begin
          fog[32*lane +: 32] = value_i.values[32*lane +: 32];
        end
      end
    end
  end

  // Who ends waits for both that are to take something of it.
  assign ends            = !in_data_i.has_values || (value_valid_i && is_last);
  assign request_valid_o = in_valid_i && in_data_i.has_values && value_valid_i && is_unit_last &&
    (!is_last || out_ready_i);
  assign out_valid_o     = in_valid_i && ends &&
    (!in_data_i.has_values || !is_unit_last || request_ready_i);
  assign value_ready_o   = in_valid_i && in_data_i.has_values &&
    (!is_unit_last || request_ready_i) && (!is_last || out_ready_i);
  assign in_ready_o      = ends && out_ready_i &&
    (!in_data_i.has_values || !is_unit_last || request_ready_i);

  // A value that waits is this quad's, if it has any, and stays: it may be taken again.
  always_ff @(posedge clk_i) begin
    if (value_valid_i) begin
      primary_q     <= primary;
      secondary_q   <= secondary;
      fog_q         <= fog;
      coordinates_q <= coordinates;
    end
  end

  always_comb begin
    request_o.tag         = quad.tag;
    request_o.draw        = quad.key.draw;
    request_o.last_unit   = is_last;
    request_o.unit        = {attribute[5], attribute[3:2]};
    request_o.live        = quad.live;
    request_o.coordinates = coordinates;
  end
  always_comb begin
    out_data_o.quad           = quad;
    out_data_o.primary        = in_data_i.constant_color ? {4{in_data_i.color}} : primary;
    out_data_o.secondary      = in_data_i.constant_secondary ? {4{in_data_i.secondary}} : secondary;
    out_data_o.fog_coordinate = fog;
  end

endmodule
