// Where anisotropic probe i of n, counted from 1, stands on a pixel's longer side: in the middle of
// the i-th of n equal parts, (i - 1/2) / n - 1/2.
//
// Combinational. Equals ffgpu::probe_position() in model/texture/coordinates.h.

module probe_position (
  input  logic [4:0]        probes_i,
  input  logic [4:0]        probe_i,
  output ffgpu_pkg::float_t position_o
);

  always_comb begin
    case ({probes_i, probe_i})
      {5'd2, 5'd1}: position_o = 32'hbe800000;
      {5'd2, 5'd2}: position_o = 32'h3e800000;
      {5'd3, 5'd1}: position_o = 32'hbeaaaaaa;
      {5'd3, 5'd2}: position_o = 32'h00000000;
      {5'd3, 5'd3}: position_o = 32'h3eaaaaaa;
      {5'd4, 5'd1}: position_o = 32'hbec00000;
      {5'd4, 5'd2}: position_o = 32'hbe000000;
      {5'd4, 5'd3}: position_o = 32'h3e000000;
      {5'd4, 5'd4}: position_o = 32'h3ec00000;
      {5'd5, 5'd1}: position_o = 32'hbecccccd;
      {5'd5, 5'd2}: position_o = 32'hbe4ccccc;
      {5'd5, 5'd3}: position_o = 32'h00000000;
      {5'd5, 5'd4}: position_o = 32'h3e4ccccc;
      {5'd5, 5'd5}: position_o = 32'h3ecccccc;
      {5'd6, 5'd1}: position_o = 32'hbed55555;
      {5'd6, 5'd2}: position_o = 32'hbe800000;
      {5'd6, 5'd3}: position_o = 32'hbdaaaaac;
      {5'd6, 5'd4}: position_o = 32'h3daaaaa8;
      {5'd6, 5'd5}: position_o = 32'h3e800000;
      {5'd6, 5'd6}: position_o = 32'h3ed55556;
      {5'd7, 5'd1}: position_o = 32'hbedb6db7;
      {5'd7, 5'd2}: position_o = 32'hbe924924;
      {5'd7, 5'd3}: position_o = 32'hbe124924;
      {5'd7, 5'd4}: position_o = 32'h00000000;
      {5'd7, 5'd5}: position_o = 32'h3e124924;
      {5'd7, 5'd6}: position_o = 32'h3e924924;
      {5'd7, 5'd7}: position_o = 32'h3edb6db6;
      {5'd8, 5'd1}: position_o = 32'hbee00000;
      {5'd8, 5'd2}: position_o = 32'hbea00000;
      {5'd8, 5'd3}: position_o = 32'hbe400000;
      {5'd8, 5'd4}: position_o = 32'hbd800000;
      {5'd8, 5'd5}: position_o = 32'h3d800000;
      {5'd8, 5'd6}: position_o = 32'h3e400000;
      {5'd8, 5'd7}: position_o = 32'h3ea00000;
      {5'd8, 5'd8}: position_o = 32'h3ee00000;
      {5'd9, 5'd1}: position_o = 32'hbee38e39;
      {5'd9, 5'd2}: position_o = 32'hbeaaaaaa;
      {5'd9, 5'd3}: position_o = 32'hbe638e38;
      {5'd9, 5'd4}: position_o = 32'hbde38e38;
      {5'd9, 5'd5}: position_o = 32'h00000000;
      {5'd9, 5'd6}: position_o = 32'h3de38e38;
      {5'd9, 5'd7}: position_o = 32'h3e638e38;
      {5'd9, 5'd8}: position_o = 32'h3eaaaaaa;
      {5'd9, 5'd9}: position_o = 32'h3ee38e38;
      {5'd10, 5'd1}: position_o = 32'hbee66666;
      {5'd10, 5'd2}: position_o = 32'hbeb33333;
      {5'd10, 5'd3}: position_o = 32'hbe800000;
      {5'd10, 5'd4}: position_o = 32'hbe19999a;
      {5'd10, 5'd5}: position_o = 32'hbd4cccd0;
      {5'd10, 5'd6}: position_o = 32'h3d4cccd0;
      {5'd10, 5'd7}: position_o = 32'h3e199998;
      {5'd10, 5'd8}: position_o = 32'h3e800000;
      {5'd10, 5'd9}: position_o = 32'h3eb33334;
      {5'd10, 5'd10}: position_o = 32'h3ee66666;
      {5'd11, 5'd1}: position_o = 32'hbee8ba2e;
      {5'd11, 5'd2}: position_o = 32'hbeba2e8c;
      {5'd11, 5'd3}: position_o = 32'hbe8ba2e8;
      {5'd11, 5'd4}: position_o = 32'hbe3a2e8c;
      {5'd11, 5'd5}: position_o = 32'hbdba2e8c;
      {5'd11, 5'd6}: position_o = 32'h00000000;
      {5'd11, 5'd7}: position_o = 32'h3dba2e88;
      {5'd11, 5'd8}: position_o = 32'h3e3a2e8c;
      {5'd11, 5'd9}: position_o = 32'h3e8ba2e8;
      {5'd11, 5'd10}: position_o = 32'h3eba2e8c;
      {5'd11, 5'd11}: position_o = 32'h3ee8ba2e;
      {5'd12, 5'd1}: position_o = 32'hbeeaaaab;
      {5'd12, 5'd2}: position_o = 32'hbec00000;
      {5'd12, 5'd3}: position_o = 32'hbe955556;
      {5'd12, 5'd4}: position_o = 32'hbe555556;
      {5'd12, 5'd5}: position_o = 32'hbe000000;
      {5'd12, 5'd6}: position_o = 32'hbd2aaaa8;
      {5'd12, 5'd7}: position_o = 32'h3d2aaab0;
      {5'd12, 5'd8}: position_o = 32'h3e000000;
      {5'd12, 5'd9}: position_o = 32'h3e555554;
      {5'd12, 5'd10}: position_o = 32'h3e955556;
      {5'd12, 5'd11}: position_o = 32'h3ec00000;
      {5'd12, 5'd12}: position_o = 32'h3eeaaaaa;
      {5'd13, 5'd1}: position_o = 32'hbeec4ec5;
      {5'd13, 5'd2}: position_o = 32'hbec4ec4f;
      {5'd13, 5'd3}: position_o = 32'hbe9d89d8;
      {5'd13, 5'd4}: position_o = 32'hbe6c4ec4;
      {5'd13, 5'd5}: position_o = 32'hbe1d89d8;
      {5'd13, 5'd6}: position_o = 32'hbd9d89d8;
      {5'd13, 5'd7}: position_o = 32'h00000000;
      {5'd13, 5'd8}: position_o = 32'h3d9d89d8;
      {5'd13, 5'd9}: position_o = 32'h3e1d89d8;
      {5'd13, 5'd10}: position_o = 32'h3e6c4ec4;
      {5'd13, 5'd11}: position_o = 32'h3e9d89d8;
      {5'd13, 5'd12}: position_o = 32'h3ec4ec4e;
      {5'd13, 5'd13}: position_o = 32'h3eec4ec4;
      {5'd14, 5'd1}: position_o = 32'hbeedb6db;
      {5'd14, 5'd2}: position_o = 32'hbec92492;
      {5'd14, 5'd3}: position_o = 32'hbea49249;
      {5'd14, 5'd4}: position_o = 32'hbe800000;
      {5'd14, 5'd5}: position_o = 32'hbe36db6e;
      {5'd14, 5'd6}: position_o = 32'hbddb6db8;
      {5'd14, 5'd7}: position_o = 32'hbd124928;
      {5'd14, 5'd8}: position_o = 32'h3d124920;
      {5'd14, 5'd9}: position_o = 32'h3ddb6db8;
      {5'd14, 5'd10}: position_o = 32'h3e36db6c;
      {5'd14, 5'd11}: position_o = 32'h3e800000;
      {5'd14, 5'd12}: position_o = 32'h3ea4924a;
      {5'd14, 5'd13}: position_o = 32'h3ec92492;
      {5'd14, 5'd14}: position_o = 32'h3eedb6dc;
      {5'd15, 5'd1}: position_o = 32'hbeeeeeef;
      {5'd15, 5'd2}: position_o = 32'hbecccccd;
      {5'd15, 5'd3}: position_o = 32'hbeaaaaaa;
      {5'd15, 5'd4}: position_o = 32'hbe888888;
      {5'd15, 5'd5}: position_o = 32'hbe4ccccc;
      {5'd15, 5'd6}: position_o = 32'hbe088888;
      {5'd15, 5'd7}: position_o = 32'hbd888888;
      {5'd15, 5'd8}: position_o = 32'h00000000;
      {5'd15, 5'd9}: position_o = 32'h3d888888;
      {5'd15, 5'd10}: position_o = 32'h3e088888;
      {5'd15, 5'd11}: position_o = 32'h3e4ccccc;
      {5'd15, 5'd12}: position_o = 32'h3e888888;
      {5'd15, 5'd13}: position_o = 32'h3eaaaaaa;
      {5'd15, 5'd14}: position_o = 32'h3ecccccc;
      {5'd15, 5'd15}: position_o = 32'h3eeeeeee;
      {5'd16, 5'd1}: position_o = 32'hbef00000;
      {5'd16, 5'd2}: position_o = 32'hbed00000;
      {5'd16, 5'd3}: position_o = 32'hbeb00000;
      {5'd16, 5'd4}: position_o = 32'hbe900000;
      {5'd16, 5'd5}: position_o = 32'hbe600000;
      {5'd16, 5'd6}: position_o = 32'hbe200000;
      {5'd16, 5'd7}: position_o = 32'hbdc00000;
      {5'd16, 5'd8}: position_o = 32'hbd000000;
      {5'd16, 5'd9}: position_o = 32'h3d000000;
      {5'd16, 5'd10}: position_o = 32'h3dc00000;
      {5'd16, 5'd11}: position_o = 32'h3e200000;
      {5'd16, 5'd12}: position_o = 32'h3e600000;
      {5'd16, 5'd13}: position_o = 32'h3e900000;
      {5'd16, 5'd14}: position_o = 32'h3eb00000;
      {5'd16, 5'd15}: position_o = 32'h3ed00000;
      {5'd16, 5'd16}: position_o = 32'h3ef00000;
      default: position_o = 32'd0;
    endcase
  end

endmodule
