// The texture unit works for all units of a draw in turn. It knows two of them at a time, each in a
// bank: what a request is under is loaded where it is not there yet, once no sample of that bank is
// on its way. A draw with one or two units loads each once.
//
// Combinational between loads, one cycle for a load. Requests leave with their bank as the tag.

module texture_banks (
  input  logic                             clk_i,
  input  logic                             rst_ni,

  // By the request's tag: contexts of the draw's units, unit 0 lowest.
  input  logic [8*1824-1:0]                contexts_0_i,
  input  logic [8*1824-1:0]                contexts_1_i,

  input  logic                             in_valid_i,
  output logic                             in_ready_o,
  input  ffgpu_pipe_pkg::sample_request_t  in_data_i,

  output logic                             out_valid_o,
  input  logic                             out_ready_i,
  output ffgpu_pipe_pkg::sample_request_t  out_data_o,

  // A sample of a bank is there.
  input  logic                             sampled_i,
  input  logic                             sampled_bank_i,

  output ffgpu_pipe_pkg::texture_context_t bank_0_o,
  output ffgpu_pipe_pkg::texture_context_t bank_1_o
);

  localparam int unsigned ContextWidth = ffgpu_pipe_pkg::TextureContextWidth;
  localparam int unsigned CountWidth = 10;  // of samples on their way

  // A context's name: the draw's number, the unit.
  ffgpu_pipe_pkg::texture_context_t bank_0_q, bank_1_q, loaded;
  logic [34:0]           name, name_0_q, name_1_q;
  logic [1:0]            named_q;
  logic [CountWidth-1:0] count_0_q, count_1_q, samples;
  logic                  last_bank_q, in_0, in_1, bank, victim, victim_free, loads, enters;

  assign name        = {in_data_i.draw, in_data_i.unit};
  assign in_0        = named_q[0] && name_0_q == name;
  assign in_1        = named_q[1] && name_1_q == name;
  assign bank        = in_1;
  assign victim      = !last_bank_q;
  assign victim_free = (victim ? count_1_q : count_0_q) == '0;
  assign loads       = in_valid_i && !in_0 && !in_1 && victim_free;
  assign out_valid_o = in_valid_i && (in_0 || in_1);
  assign in_ready_o  = out_ready_i && (in_0 || in_1);
  assign enters      = out_valid_o && out_ready_i;
  assign bank_0_o    = bank_0_q;
  assign bank_1_o    = bank_1_q;

  always_comb begin
    out_data_o     = in_data_i;
    out_data_o.tag = bank;
  end

  // Unit by unit: a place in so wide a vector would be a shifter.
  always_comb begin
    loaded = '0;
    if (loads) begin
      for (int unsigned unit = 0; unit < 8; unit++) begin
        if (in_data_i.unit == unit[2:0]) begin
          loaded = in_data_i.tag ? contexts_1_i[ContextWidth*unit +: ContextWidth] :
            contexts_0_i[ContextWidth*unit +: ContextWidth];
        end
      end
    end
  end

  // Each live lane will be a sample.
  always_comb begin
    samples = '0;
    for (int unsigned lane = 0; lane < 4; lane++) begin
      samples = samples + {{CountWidth-1{1'b0}}, in_data_i.live[lane] && enters};
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      named_q     <= 2'b00;
      last_bank_q <= 1'b0;
      count_0_q   <= '0;
      count_1_q   <= '0;
    end else begin
      if (loads) begin
        named_q[victim] <= 1'b1;
      end
      if (enters) begin
        last_bank_q <= bank;
      end
      count_0_q <= count_0_q + (bank ? '0 : samples) -
        {{CountWidth-1{1'b0}}, sampled_i && !sampled_bank_i};
      count_1_q <= count_1_q + (bank ? samples : '0) -
        {{CountWidth-1{1'b0}}, sampled_i && sampled_bank_i};
    end
  end
  always_ff @(posedge clk_i) begin
    if (loads && !victim) begin
      name_0_q <= name;
      bank_0_q <= loaded;
    end
    if (loads && victim) begin
      name_1_q <= name;
      bank_1_q <= loaded;
    end
  end

endmodule
