// Twice the exact result of a combiner's operation for one channel, in units of 1 / 65025: the
// factor 2 keeps the halves of the signed operations whole. Operations beyond the list replace.
//
// Combinational. Equals doubled_result() in model/fragment/texture_environment.cpp; dot products
// are made by combine_dot.

module combine_operation (
  input  logic                                 enable_i,  // low: nobody looks at the result
  input  logic [3:0]                           operation_i,
  input  logic [31:0]                          arguments_i,  // argument 0 lowest
  output logic [ffgpu_pkg::DoubledWidth-1:0]   doubled_o
);

  localparam logic [15:0] One = 16'd255;
  localparam logic signed [19:0] OneSquared = 20'sd65025;

  logic [15:0] a0, a1, a2, a3, first_factor, second_factor, second_term, first, second;
  logic        negates, is_signed;
  logic signed [19:0] sum;

  assign a0 = {8'd0, arguments_i[7:0]};
  assign a1 = {8'd0, arguments_i[15:8]};
  assign a2 = {8'd0, arguments_i[23:16]};
  assign a3 = {8'd0, arguments_i[31:24]};

  // All are a0 * first_factor +- second_term * second_factor, perhaps less a half.
  always_comb begin
    first_factor  = One;
    second_term   = a1;
    second_factor = 16'd0;
    negates       = 1'b0;
    is_signed     = 1'b0;
    first         = 16'd0;
    second        = 16'd0;
    sum           = 20'sd0;
    if (enable_i) begin
      unique case (operation_i)
        ffgpu_registers_pkg::CombineOpModulate: first_factor = a1;
        ffgpu_registers_pkg::CombineOpAdd:      second_factor = One;
        ffgpu_registers_pkg::CombineOpAddSigned: begin
          second_factor = One;
          is_signed     = 1'b1;
        end
        ffgpu_registers_pkg::CombineOpInterpolate: begin
          first_factor  = a2;
          second_factor = One - a2;
        end
        ffgpu_registers_pkg::CombineOpSubtract: begin
          second_factor = One;
          negates       = 1'b1;
        end
        ffgpu_registers_pkg::CombineOpModulateAdd: begin
          first_factor  = a2;
          second_factor = One;
        end
        ffgpu_registers_pkg::CombineOpModulateSignedAdd: begin
          first_factor  = a2;
          second_factor = One;
          is_signed     = 1'b1;
        end
        ffgpu_registers_pkg::CombineOpModulateSubtract: begin
          first_factor  = a2;
          second_factor = One;
          negates       = 1'b1;
        end
        ffgpu_registers_pkg::CombineOpAddProducts: begin
          first_factor  = a1;
          second_term   = a2;
          second_factor = a3;
        end
        ffgpu_registers_pkg::CombineOpAddProductsSigned: begin
          first_factor  = a1;
          second_term   = a2;
          second_factor = a3;
          is_signed     = 1'b1;
        end
        default: second_factor = 16'd0;
      endcase

      first  = a0 * first_factor;
      second = second_term * second_factor;
      sum    = negates ? $signed({3'd0, first, 1'b0}) - $signed({3'd0, second, 1'b0}) :
        $signed({3'd0, first, 1'b0}) + $signed({3'd0, second, 1'b0});
      if (is_signed) begin
        sum = sum - OneSquared;
      end
    end
  end
  assign doubled_o = sum;

endmodule
